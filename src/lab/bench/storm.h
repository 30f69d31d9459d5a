/// A soak test: random throws at a balloon on the floor that is inflated and deflated at random. A
/// ball every half second, from a random direction above, at up to 200 m/s, of random radius,
/// lighter or heavier than the balloon, at its center or past it. Every ten seconds all balls are
/// removed.
#ifndef BALLOON_LAB_BENCH_STORM_H
#define BALLOON_LAB_BENCH_STORM_H

#include "base/random.h"
#include "world/world.h"

enum {
    STORM_RATE = 250,   ///< steps a second
    STORM_THROW = 125,  ///< steps between throws
    STORM_KEY = 500,    ///< steps from a key's press to its release, and to the next press
    STORM_CLEAR = 2500, ///< steps between removals of all balls
    STORM_BALLS = STORM_CLEAR / STORM_THROW
};

typedef struct Storm {
    World world;
    Random random;
    int winding[STORM_BALLS]; ///< winding number of the skin around each ball at its throw
} Storm;

bool storm_open(Storm* storm, uint64_t seed, Fault* fault);

/// The events that are due, then a step of the world.
bool storm_step(Storm* storm, Fault* fault);

/// Number of balls around which the winding number of the skin, its solid angle over 4 pi, differs
/// from that at the throw. It checks the world's count of pass-throughs independently of contacts
/// and CCD: the winding number around a point changes only when the skin crosses the point, even if
/// the skin overlaps itself.
int storm_astray(const Storm* storm);

void storm_close(Storm* storm);

#endif
