/// What pulls and pushes on a thing.
#ifndef BALLOON_WORLD_THINGS_THING_LOAD_H
#define BALLOON_WORLD_THINGS_THING_LOAD_H

#include "world/world.h"

typedef struct ThingLoad {
    double4 force;  ///< [N]
    double4 moment; ///< about the thing's present origin [N m]
} ThingLoad;

/// Contacts by their impulses of the last step; strings and pinned particles by the forces of the
/// present state, without the inertia of those particles.
ThingLoad thing_load(const World* world, int thing);

#endif
