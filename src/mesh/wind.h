/// Winding: every face the same way round as its neighbours, and closed skins outward.
#ifndef BALLOON_MESH_WIND_H
#define BALLOON_MESH_WIND_H

#include "mesh/edges.h"
#include "mesh/source.h"

typedef struct Winding {
    int components; ///< parts that hang together by edges
    int flipped;    ///< faces turned over
    int clash[2];   ///< two faces that cannot both face outward, NONE if all can
} Winding;

/// Flood each component over its edges of two faces. The majority of its faces keeps its way; then
/// a closed component is turned so that its volume is positive. Faces are turned over in place,
/// first corner first; the sides of `edges` are those of the faces as they were.
Winding wind_faces(MeshSource* source, const Edges* edges);

#endif
