/// A thing's surface in the picture: opaque, with sharp edges where faces meet at an angle.
#ifndef BALLOON_VIEW_THING_SURFACE_H
#define BALLOON_VIEW_THING_SURFACE_H

#include "view/picture.h"
#include "world/world.h"

/// Each corner of a triangle is a point of its own, with the mean normal of the triangles around it
/// that are at most 40 degrees apart from its own. color: [3] sRGB, or NULL for gray.
void thing_surface_open(PictureSkin* skin, const Thing* thing, const double* color);

/// Copy the positions. Returns whether any has changed.
bool thing_surface_update(PictureSkin* skin, const Thing* thing);

void thing_surface_close(PictureSkin* skin);

#endif
