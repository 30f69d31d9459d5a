/// A ball thrown at a free balloon of radius 1 in still air, with no floor below.
#ifndef BALLOON_LAB_BENCH_THROW_H
#define BALLOON_LAB_BENCH_THROW_H

#include "world/world.h"

enum { THROW_WAYS = 4 }; ///< middle of a patch, a corner of valence 3, somewhere, it grazes

typedef struct Throw {
    double speed;       ///< [m/s]
    double radius;      ///< [m], the balloon's is 1
    double rate;        ///< steps a second
    double mass;        ///< [balloon's]
    double restitution; ///< [1]
    double friction;    ///< [1]
    int side;           ///< quads a side of the cube-sphere
    int way;            ///< 0 … THROW_WAYS - 1: from where, and how far off the middle
} Throw;

/// The world in which the ball is on its way.
bool throw_open(const Throw* t, World* world, Fault* fault);

/// Steps until the ball could have gone through and past the other side, but no more than a second.
long throw_steps(const Throw* t);

#endif
