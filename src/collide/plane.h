/// The floor and walls: half-spaces that particles stop on, sliding no more than Coulomb's friction
/// lets them. Balls meet the same planes in Bullet.
#ifndef BALLOON_COLLIDE_PLANE_H
#define BALLOON_COLLIDE_PLANE_H

#include "body/body.h"

typedef struct Plane {
    double4 point;
    double4 normal; ///< of unit length, to the side where things are
} Plane;

/// Change velocities so that no particle ends a drift of length h behind the plane. Inelastic; each
/// particle for itself, so in closed form. Whether any had to stop.
bool plane_stop(Body* body, const Plane* plane, double h);

#endif
