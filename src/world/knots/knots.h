/// The scene's knots, and its strings to knots and to other balloons (solve/joints/joints.h).
#ifndef BALLOON_WORLD_KNOTS_KNOTS_H
#define BALLOON_WORLD_KNOTS_KNOTS_H

#include "world/world.h"

/// Prepare the scene's knots. A fault if the method steps no joined bodies. Balloons must be open.
bool knots_open(World* world, Fault* fault);

/// Make knots and joints at the start of the scene, in the world's system.
void knots_begin(World* world);

/// Tie or untie the joints of a balloon; returns whether it has any.
bool knots_tie(World* world, int balloon);

/// The joint of string `string` of a balloon; NULL: the string leads to a fixed point.
const Joint* knots_joint(const World* world, int balloon, int string);

void knots_close(World* world);

#endif
