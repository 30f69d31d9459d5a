/// Points of a thing at the start of its path.
#ifndef BALLOON_WORLD_THINGS_THING_POINT_H
#define BALLOON_WORLD_THINGS_THING_POINT_H

#include "contact/things/thing.h"

/// The point that `at` names, "lowest", "highest" or a number; else the point of the surface nearest
/// to x, or the middle of the bounding box where x is NULL.
void thing_point_at(const Thing* thing, const char* at, const double4* x, double point[3]);

#endif
