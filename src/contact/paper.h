/// The mass-spring paper's penalty, for its figures: keeps no momentum and lets fast balls through.
///
/// After the particles have moved, each one inside a ball is moved out along the line from the
/// ball's centre, and pushes the ball the other way with 50 k_normal. Source: the mass-spring
/// balloon paper, "Collision Detection and Resolution"; 50 is its authors' factor.
#ifndef BALLOON_CONTACT_PAPER_H
#define BALLOON_CONTACT_PAPER_H

#include "body/body.h"
#include "contact/sphere.h"

/// Move the particles of a skin out of a ball. Returns the force on the ball [N].
real4 paper_push(const Sphere* sphere, Body* body);

#endif
