/// A balloon's surface as a picture needs it: positions, normals and stretch at each point.
#ifndef BALLOON_VIEW_SURFACE_H
#define BALLOON_VIEW_SURFACE_H

#include "view/picture.h"
#include "world/world.h"

/// Arrays and what does not change from frame to frame.
void surface_open(PictureSkin* skin, const Balloon* balloon);

/// The present positions; unit normals, the mean of the faces around a point weighted by area;
/// stretch, the mean over the edges at a point of length over rest length, or of rubber over its
/// elements at a point of the larger principal stretch. False where nothing has moved since the
/// last time, and nothing is computed.
bool surface_update(PictureSkin* skin, const Balloon* balloon);

/// Mean length of an edge at rest, in world units: the measure of what is drawn on a skin.
float surface_edge_length(const Balloon* balloon);

void surface_close(PictureSkin* skin);

#endif
