/// A balloon's surface in a picture: positions, normals and stretch at each point.
#ifndef BALLOON_VIEW_SURFACE_H
#define BALLOON_VIEW_SURFACE_H

#include "view/picture.h"
#include "world/world.h"

/// Allocate the arrays and set what stays the same from frame to frame.
void surface_open(PictureSkin* skin, const Balloon* balloon);

/// Compute positions; unit normals (the area-weighted mean of the faces at a point); and stretch
/// (length over rest length, mean of the edges at a point; for rubber the larger principal stretch,
/// mean of the elements at a point, weighted by area at rest). Returns false, and computes nothing,
/// if no point has moved since the last call.
bool surface_update(PictureSkin* skin, const Balloon* balloon);

/// Mean length of an edge at rest, in world units.
float surface_edge_length(const Balloon* balloon);

void surface_close(PictureSkin* skin);

#endif
