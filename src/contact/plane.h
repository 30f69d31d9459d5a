/// The floor and walls: half-spaces that particles stop on, sliding no more than Coulomb's friction
/// lets them.
#ifndef BALLOON_CONTACT_PLANE_H
#define BALLOON_CONTACT_PLANE_H

#include "body/body.h"
#include "body/extent.h"

typedef struct Plane {
    double4 point;
    double4 normal; ///< of unit length, to the side where things are
    real friction;  ///< Coulomb's coefficient of particles on it
} Plane;

/// Distance from a plane, less than 0 behind it [m].
static inline real plane_gap(const Plane* plane, real4 x) {
    return dot(to_real4(plane->normal), x - to_real4(plane->point));
}

/// Lower bound of the gaps of the points in a box; NaN where the box is not finite.
double plane_box_gap(const Plane* plane, const Extent* x);

/// Whether any of the particles in the box x and as fast as v may come to the plane in a drift of
/// length h, or is behind it.
bool plane_within(const Plane* plane, const Extent* x, const Extent* v, double h);

/// Change velocities so that no particle ends a drift of length h behind the plane. Inelastic; each
/// particle for itself, so in closed form. Returns the sum of the normal impulses [N s], and adds to
/// `work` the kinetic energy that particles behind the plane get to come out [J].
double plane_stop(Body* body, const Plane* plane, double h, double* work);

#endif
