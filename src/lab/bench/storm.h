/// Random throws at a balloon on the floor that is blown up and let out, for as long as one likes:
/// a ball every half second, from anywhere, at anything up to 200 m/s, of any size, lighter or
/// heavier than the balloon, at its middle or past it. Every ten seconds all balls are taken away.
#ifndef BALLOON_LAB_BENCH_STORM_H
#define BALLOON_LAB_BENCH_STORM_H

#include "base/random.h"
#include "world/world.h"

enum {
    STORM_RATE = 250,   ///< steps a second
    STORM_THROW = 125,  ///< steps from a throw to the next
    STORM_KEY = 500,    ///< steps from a key's press to its release, and to the next
    STORM_CLEAR = 2500, ///< steps from one clearing away to the next
    STORM_BALLS = STORM_CLEAR / STORM_THROW
};

typedef struct Storm {
    World world;
    Random random;
    int winding[STORM_BALLS]; ///< of the skin around each ball when it was thrown
} Storm;

bool storm_open(Storm* storm, uint64_t seed, Fault* fault);

/// What the hand does now, and a step of the world.
bool storm_step(Storm* storm, Fault* fault);

/// How many balls the skin winds around otherwise than when they were thrown, by its solid angle:
/// a check on the world's count of pass-throughs that knows nothing of contacts and sweeps. The
/// winding around a point changes only when the skin goes through the point, whether the skin
/// overlaps itself or not.
int storm_astray(const Storm* storm);

void storm_close(Storm* storm);

#endif
