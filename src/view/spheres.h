/// The world's balls in a picture.
#ifndef BALLOON_VIEW_SPHERES_H
#define BALLOON_VIEW_SPHERES_H

#include "view/picture.h"
#include "world/world.h"

/// Draw all balls, each in the next color of a palette.
void spheres_add(Picture* picture, const World* world);

/// Extend the bounding box of a scene by the balls that are near it. A ball that has flown away is
/// left out: framing it would make everything else small.
void spheres_widen(const World* world, float low[3], float high[3]);

#endif
