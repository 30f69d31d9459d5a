/// Seams: rims that lie on each other exactly, because the file gave each side its own points.
///
/// Two rim edges between the same two places are sewn together, if they are the only edges there;
/// points become one only by being the ends of sewn edges. So sheets that touch in a point or along
/// a closed edge stay apart, and no edge comes to have three faces.
#ifndef BALLOON_MESH_WELD_H
#define BALLOON_MESH_WELD_H

#include "mesh/source.h"

/// Give the corners that are sewn together the number of the first of them, and return how many
/// points are left without a face by it.
int weld_seams(MeshSource* source);

#endif
