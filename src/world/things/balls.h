/// The balls that a scene begins with.
#ifndef BALLOON_WORLD_THINGS_BALLS_H
#define BALLOON_WORLD_THINGS_BALLS_H

#include "world/world.h"

/// Add them to the world's contacts, after its things. One that begins across a skin or a thing is
/// moved out of it, and the world's notice says so.
void balls_begin(World* world);

#endif
