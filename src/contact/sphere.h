/// A rigid ball: thrown at balloons, resting on them, rolling on the floor.
#ifndef BALLOON_CONTACT_SPHERE_H
#define BALLOON_CONTACT_SPHERE_H

#include "base/vec.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct Sphere {
    real4 x;          ///< centre [m]
    real4 v;          ///< velocity [m/s]
    real4 spin;       ///< angular velocity [rad/s]
    real radius;      ///< [m]
    real mass;        ///< [kg]
    real restitution; ///< of a first hit, 0 sticks, 1 bounces back as fast
    real friction;    ///< Coulomb's coefficient against skins, floor and other spheres
    real4 impulse;    ///< of all contacts in this step (contact/reaction.h) [N s]
} Sphere;

/// A ball that does not spin, from the numbers of a scene or a log.
static inline Sphere sphere_of(const double x[3], const double v[3], double radius, double mass,
                               double restitution, double friction) {
    const real4 position = {(real)x[0], (real)x[1], (real)x[2], 0};
    const real4 velocity = {(real)v[0], (real)v[1], (real)v[2], 0};
    const real4 nothing = {0, 0, 0, 0};
    const Sphere sphere = {position,   velocity,          nothing,        (real)radius,
                           (real)mass, (real)restitution, (real)friction, nothing};
    return sphere; // in order and by name, because C++ has neither designators nor literals
}

/// Moment of inertia of a solid ball about its centre [kg m^2].
static inline real sphere_inertia(const Sphere* sphere) {
    return (real)0.4 * sphere->mass * sphere->radius * sphere->radius;
}

#ifdef __cplusplus
}
#endif

#endif
