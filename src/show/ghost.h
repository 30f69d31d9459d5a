/// A second copy of the scene, stepped by another method with the same input. `--compare` draws it as
/// a translucent ghost, and compares error and cost of the two.
#ifndef BALLOON_SHOW_GHOST_H
#define BALLOON_SHOW_GHOST_H

#include "world/world.h"

typedef struct Ghost {
    World world;
    double spent;       ///< CPU time of the scene's own steps [s]
    double ghost_spent; ///< CPU time of the ghost's steps [s]
} Ghost;

/// One step of both worlds; their CPU times are counted separately.
void ghost_step(Ghost* ghost, World* world);

/// Root-mean-square distance between the ghost's particles and the world's [m].
double ghost_distance(const Ghost* ghost, const World* world);

/// CPU time per simulated second of the world, or of its ghost [ms]; 0 before the first step.
double ghost_cost(const Ghost* ghost, const World* world, bool of_ghost);

/// "newton is 0.012 off, for 40 ms per second against 12", and the step of a blowup.
void ghost_summary(const Ghost* ghost, const World* world, char* words, size_t size);

#endif
