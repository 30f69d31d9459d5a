/// The next ball that the user throws, along the line of sight through the pointer:
///
///     x = eye + t d,   v = speed d,   d = camera_ray at the pointer
///
/// The ball covers the pixel under the pointer until gravity bends its path. World units only.
#ifndef BALLOON_VIEW_THROWER_H
#define BALLOON_VIEW_THROWER_H

#include "view/camera.h"
#include "world/world.h"

typedef struct Thrower {
    double mass;   ///< [kg]
    double radius; ///< [m]
    double speed;  ///< [m/s]
} Thrower;

/// A ball that suits the scene: about as heavy as a balloon, an eighth of its size, and fast enough
/// to reach the camera's target on an almost straight path.
Thrower thrower_default(const World* world, const Camera* camera);

/// Change to the next larger mass (0.1, 1, 10, …), radius or speed; after the largest comes the
/// smallest.
void thrower_next_mass(Thrower* thrower);
void thrower_next_radius(Thrower* thrower);
void thrower_next_speed(Thrower* thrower);

/// Compute the numbers of a throw event: position, velocity, mass, radius. pointer: 0…1 from the
/// window's upper left. The ball starts near the eye, in front of the bounding boxes of all balloons
/// that do not contain the eye. Returns false if floor, walls or another ball are in its way.
bool thrower_throw(const Thrower* thrower, const World* world, const Camera* camera, float aspect,
                   const float pointer[2], double thrown[THROW_NUMBERS]);

#endif
