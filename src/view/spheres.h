/// The world's balls as a picture shows them.
#ifndef BALLOON_VIEW_SPHERES_H
#define BALLOON_VIEW_SPHERES_H

#include "view/picture.h"
#include "world/world.h"

/// Draw all balls, each in the next colour of a palette.
void spheres_add(Picture* picture, const World* world);

/// Widen the box of what a scene is by the balls that are near it. One that has flown away is no
/// part of the scene any more: it would make everything else small.
void spheres_widen(const World* world, float low[3], float high[3]);

#endif
