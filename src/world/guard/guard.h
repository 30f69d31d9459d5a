/// The guard of the step: compares a scene's step with the largest stable one.
///
/// The bound of semi-implicit Euler for the largest squared frequency w^2 and the damping rate
/// g = c/m is h = (-g + sqrt(g^2 + 4 w^2)) / w^2 (solve/method.h). Where the scene's step is above
/// it, `split` divides the step into equal substeps, `stop` refuses it, `off` lets it run. Where no
/// step is stable, as with `forward` without damping, both `split` and `stop` refuse.
///
/// The bound belongs to one state, and a substep must be stable up to the next look:
///
///     look     before a step with a multiple of GUARD_INTERVAL, and after as many substeps
///     expect   bound at the next look = bound b of this one times b / last b, within 1/2 to 1
///     hold     fewer substeps only after HOLD_LOOKS looks in a row that ask for fewer
///
/// Measured without these three. `peak` by semi-implicit Euler: 156 substeps at the first look, the
/// limit falls as the balloon grows (the gas's stiffness is proportional to V^(1/3)), and the state
/// is gone after 7 steps, 1092 substeps later. A ball of neo-Hookean rubber, undamped: the bound
/// moves between 2.4e-4 s and 4e-5 s within 16 steps, because the law is stiff as 1/D^3 in an element whose squared area ratio D is small. With a look before every
/// substep, and each as long as its bound, the energy grows faster still: an element is entered
/// with a long step and left with a short one, and a symplectic method of varying steps keeps no
/// energy. At equal steps of 5e-5 s the energy is kept to 0.05 J of 8 J.
///
/// Contacts divide a drift, and not the kick of an explicit method. A bound holds for kicks of equal
/// lengths: kicks of h1 and h2 in turn multiply a mode of frequency w by a matrix of trace
/// 2 - w^2 (h1 + h2)^2 + w^4 h1^2 h2^2, which leaves -2 to 2 from w h1 = 1.9, w h2 = 0.5 on. With a
/// kick for each part, `party` gained energy from 10^4 J to 10^8 J in 1.5 s beside fast balls.
///
/// Methods of constraints are stable at every step, and wrong at long ones. Under `split` a step of
/// theirs whose residual is above RESIDUAL_MAX is halved as one that is not solved.
///
/// Contacts and strain limits correct velocities after the solve of an implicit step, by impulses
/// that know no spring: a skin gives way by what its springs do in one step. Substeps with such
/// corrections are at most the explicit bound, under `split`. (Contacts of `newton` are not counted.)
#ifndef BALLOON_WORLD_GUARD_GUARD_H
#define BALLOON_WORLD_GUARD_GUARD_H

#include "scene/scene.h"
#include "solve/method.h"

/// Of backward Euler's equation, relative [1]: a skin of springs is then at most 2 % too large.
#define RESIDUAL_MAX 0.25

enum {
    GUARD_INTERVAL = 16, ///< [substeps] between two computations of the bound
    HOLD_LOOKS = 64,     ///< looks for which a number of substeps is held
    SUBSTEPS_MAX = 10000 ///< more substeps than this are refused
};

typedef struct StepGuard {
    Guard mode;
    double bound;      ///< largest stable step when it was last computed [s]
    int substeps;      ///< equal parts of each step
    bool changed;      ///< compute the bound before the next step
    int since_look;    ///< substeps since the bound was computed
    int calm_looks;    ///< looks in a row that asked for fewer substeps
    int calm_substeps; ///< largest number that those looks asked for
    int noticed;       ///< substeps of the last notice
    int refinement;    ///< substeps are multiplied by it: a power of 2, by the energy watch
    bool made_again;   ///< this step was taken back: its substeps stay as short as they are
    long taken_back;   ///< steps that the energy watch has taken back
} StepGuard;

typedef enum GuardVerdict {
    VERDICT_GOOD,
    VERDICT_SPLIT,        ///< into many more substeps than before
    VERDICT_TOO_LONG,     ///< the step is above the bound, and the mode is `stop`
    VERDICT_NEVER_STABLE, ///< no step is stable
    VERDICT_TOO_MANY      ///< more than SUBSTEPS_MAX
} GuardVerdict;

/// Whether the guard may split steps of this method.
static inline bool guard_splits(const StepGuard* guard, const Method* method) {
    return guard->mode == GUARD_SPLIT && !method->implicit;
}

/// A guard that has not looked yet.
StepGuard guard_new(Guard mode);

/// Smallest bound of all bodies that are awake [s], INFINITY where there is none; *body is the body
/// with that bound.
double guard_bound(const Method* method, const System* system, int* body);

/// Longest implicit substep whose velocities are corrected [s]: the explicit bound of all bodies;
/// INFINITY where none is limited.
double guard_bound_corrected(const StepGuard* guard, const Method* method, const System* system);

/// Whether a body of the system has strain limits.
bool guard_limits_strain(const System* system);

/// Whether the bound must be computed before the next step, or within one.
bool guard_due(const StepGuard* guard, long step_count);
bool guard_due_within(const StepGuard* guard);

/// Compute the bound, and from it the substeps of a step [s]. *body is the body with the bound.
GuardVerdict guard_update(StepGuard* guard, const Method* method, const System* system, double step,
                          int* body);

/// Halve all substeps, and hold them. False at the floor: they have been divided by REFINEMENT_MAX.
bool guard_refine(StepGuard* guard);

#endif
