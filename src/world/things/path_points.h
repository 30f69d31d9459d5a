/// The path of a thing or of a knot, as its scene gives it.
#ifndef BALLOON_WORLD_THINGS_PATH_POINTS_H
#define BALLOON_WORLD_THINGS_PATH_POINTS_H

#include "contact/things/thing.h"
#include "scene/scene.h"

/// [count] points, which the caller frees.
PathPoint* path_points(const PathPointDef* def, unsigned count);

#endif
