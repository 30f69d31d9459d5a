/// A ball thrown at a free balloon of radius 1 in still air, with no floor below.
#ifndef BALLOON_LAB_BENCH_THROW_H
#define BALLOON_LAB_BENCH_THROW_H

#include "world/world.h"

enum { THROW_AIMS = 4 }; ///< center of a patch, corner of valence 3, off center, grazing

typedef struct Throw {
    double speed;       ///< [m/s]
    double radius;      ///< [m], the balloon's is 1
    double rate;        ///< steps a second
    double mass;        ///< [balloon's]
    double restitution; ///< [1]
    double friction;    ///< [1]
    int side;           ///< quads a side of the cube-sphere
    int aim;            ///< 0 … THROW_AIMS - 1: direction and offset from the balloon's center
} Throw;

/// Open a world with the balloon and the flying ball.
bool throw_open(const Throw* t, World* world, Fault* fault);

/// Number of steps in which the ball could pass the whole balloon, at most a second.
long throw_steps(const Throw* t);

#endif
