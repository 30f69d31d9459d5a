/// The floor and walls: half-spaces that particles stop on, sliding no more than Coulomb's friction
/// lets them. Balls meet the same planes in Bullet.
#ifndef BALLOON_CONTACT_PLANE_H
#define BALLOON_CONTACT_PLANE_H

#include "body/body.h"
#include "body/extent.h"

typedef struct Plane {
    double4 point;
    double4 normal; ///< of unit length, to the side where things are
} Plane;

/// Whether any of the particles in the box x and as fast as v may come to the plane in a drift of
/// length h, or is behind it.
bool plane_within(const Plane* plane, const Extent* x, const Extent* v, double h);

/// Change velocities so that no particle ends a drift of length h behind the plane. Inelastic; each
/// particle for itself, so in closed form. Whether any had to stop.
bool plane_stop(Body* body, const Plane* plane, double h);

#endif
