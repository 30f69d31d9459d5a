/// Welds seams: rims at exactly the same positions, because the file has two points for each.
///
/// Two rim edges between the same two positions are sewn together, if they are the only edges
/// there; points are merged only as the ends of sewn edges. So sheets that touch in a point or
/// along an edge inside them stay apart, and no edge gets a third face.
#ifndef BALLOON_MESH_WELD_H
#define BALLOON_MESH_WELD_H

#include "mesh/source.h"

/// Replace the corners that are sewn together by the first of them. Returns the number of points
/// that no face uses any more.
int weld_seams(MeshSource* source);

#endif
