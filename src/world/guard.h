/// Holds the step against the scene's stability bound, and catches a state that goes bad.
///
/// The bound of semi-implicit Euler for the largest squared frequency w^2 and the damping rate
/// g = c/m is h = (-g + sqrt(g^2 + 4 w^2)) / w^2 (solve/method.h). Where the scene's step is above
/// it, `split` divides the step into equal substeps, `stop` refuses, `off` lets it run; where no
/// step is stable, as of `forward` without damping, both refuse. The bound is taken again every
/// GUARD_INTERVAL steps, for it moves with the pressure.
///
/// A state is bad when a particle's position is not finite, or when in one drift it moves by more
/// than ten times the balloon's first size against the balloon's mean: found at that step in every
/// mode. So is a ball that is not finite, a gas whose volume is down to nothing, and an element of
/// rubber that has no thickness left. The last good
/// state, at most GUARD_INTERVAL steps old, is put back and the world halts.
#ifndef BALLOON_WORLD_GUARD_H
#define BALLOON_WORLD_GUARD_H

enum {
    GUARD_INTERVAL = 16,  ///< [steps] between two looks at the bound
    SUBSTEPS_MOST = 10000 ///< more than this is a scene that asks for the wrong thing
};

typedef struct World World;

/// Take the bound of the present state, and split the step or refuse it.
void guard_look(World* world);

/// Say that a balloon's step could not be solved, not even in parts of h; put the last good state
/// back and halt.
void guard_unsolved(World* world, int balloon, double h);

/// Remember the present state as the last good one.
void guard_keep(World* world);

/// After a step: find a bad state, name it, put the last good one back and halt; else keep this one
/// every GUARD_INTERVAL steps.
void guard_check(World* world);

#endif
