/// The guard of the step: compares a scene's step with the largest stable one.
///
/// The bound of semi-implicit Euler for the largest squared frequency w^2 and the damping rate
/// g = c/m is h = (-g + sqrt(g^2 + 4 w^2)) / w^2 (solve/method.h). Where the scene's step is above
/// it, `split` divides the step into equal substeps, `stop` refuses it, `off` lets it run. Where no
/// step is stable, as with `forward` without damping, both `split` and `stop` refuse. The bound is
/// computed again every GUARD_INTERVAL steps, for it changes with the pressure.
#ifndef BALLOON_WORLD_GUARD_H
#define BALLOON_WORLD_GUARD_H

#include "scene/scene.h"
#include "solve/method.h"

enum {
    GUARD_INTERVAL = 16, ///< [steps] between two computations of the bound
    SUBSTEPS_MAX = 10000 ///< more substeps than this are refused
};

typedef struct StepGuard {
    Guard mode;
    double bound; ///< largest stable step when it was last computed [s]
    int substeps; ///< equal parts of each step
    bool changed; ///< compute the bound before the next step
} StepGuard;

typedef enum GuardVerdict {
    VERDICT_GOOD,
    VERDICT_SPLIT,        ///< into more substeps than before
    VERDICT_TOO_LONG,     ///< the step is above the bound, and the mode is `stop`
    VERDICT_NEVER_STABLE, ///< no step is stable
    VERDICT_TOO_MANY      ///< more than SUBSTEPS_MAX
} GuardVerdict;

/// Smallest bound of all bodies that are awake [s], INFINITY where there is none; *body is the body
/// with that bound.
double guard_bound(const Method* method, const System* system, int* body);

/// Compute the bound, and from it the substeps of a step [s]. *body is the body with the bound.
GuardVerdict guard_update(StepGuard* guard, const Method* method, const System* system, double step,
                          int* body);

#endif
