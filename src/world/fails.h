/// Whether a scene fails as it states (FailsDef in scene/scene.h).
#ifndef BALLOON_WORLD_FAILS_H
#define BALLOON_WORLD_FAILS_H

#include "world/world.h"

/// Whether the world, stepped up to `fails.at`, has failed as its scene states. False for a world
/// that has halted before an output could be read.
bool fails_seen(const World* world);

/// "by 2 s the state goes bad; cure: step=0.002", or "balloon0.volume at 2 s is below 1, not 1.22".
void fails_words(const FailsDef* fails, char* words, size_t size);

#endif
