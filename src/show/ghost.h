/// A second copy of the scene, stepped by another method with the same input: what `--compare`
/// shows as a see-through ghost, and what it says of the two.
#ifndef BALLOON_SHOW_GHOST_H
#define BALLOON_SHOW_GHOST_H

#include "world/world.h"

typedef struct Ghost {
    World world;
    double spent;       ///< CPU time of the scene's own steps [s]
    double ghost_spent; ///< and of the ghost's [s]
} Ghost;

/// One step of both, each on its own clock.
void ghost_step(Ghost* ghost, World* world);

/// How far the ghost's particles are from the world's: root of the mean square [m].
double ghost_distance(const Ghost* ghost, const World* world);

/// CPU time per simulated second of the world, or of its ghost [ms]; 0 at the start.
double ghost_cost(const Ghost* ghost, const World* world, bool of_ghost);

/// "newton is 0.012 off, for 40 ms per second against 12", or where it went bad.
void ghost_summary(const Ghost* ghost, const World* world, char* words, size_t size);

#endif
