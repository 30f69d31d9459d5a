/// The things of a scene: loading, placing, and what is refused of them.
#ifndef BALLOON_WORLD_THINGS_THINGS_H
#define BALLOON_WORLD_THINGS_THINGS_H

#include "world/world.h"

/// Load the scene's things and place them. A model that is not there or no mesh, or a thing that
/// crosses a balloon at the start, is a fault. Balloons must be open.
bool things_open(World* world, Fault* fault);

/// Put all things back to the start of their paths, and add them to the world's contacts.
void things_begin(World* world);

/// Say it once where a thing is held up.
void things_notice(World* world);

void things_close(World* world);

#endif
