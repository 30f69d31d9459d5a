/// The user's hand: the next ball, and how it is thrown from the eye to where the pointer is.
///
///     x = eye + t d,   v = speed d,   d = camera_ray at the pointer
///
/// so that its path begins on the line of sight: the ball covers the pixel that was pointed at,
/// until gravity has bent the path. World units only.
#ifndef BALLOON_VIEW_THROWER_H
#define BALLOON_VIEW_THROWER_H

#include "view/camera.h"
#include "world/world.h"

typedef struct Thrower {
    double mass;   ///< [kg]
    double radius; ///< [m]
    double speed;  ///< [m/s]
} Thrower;

/// A ball that suits the scene: about as heavy as a balloon and an eighth of its size, and so fast
/// that it meets what the eye looks at.
Thrower thrower_default(const World* world, const Camera* camera);

/// Go on to the next larger mass (0.1, 1, 10, …), radius or speed, from the largest to the least.
void thrower_next_mass(Thrower* thrower);
void thrower_next_radius(Thrower* thrower);
void thrower_next_speed(Thrower* thrower);

/// The numbers of the event: position, velocity, mass, radius. pointer: 0…1 from the window's upper
/// left. The ball starts a little before the eye, in front of the boxes of all balloons that the
/// eye is not within. False where floor, walls or another ball leave no room for it.
bool thrower_throw(const Thrower* thrower, const World* world, const Camera* camera, float aspect,
                   const float pointer[2], double thrown[THROW_NUMBERS]);

#endif
