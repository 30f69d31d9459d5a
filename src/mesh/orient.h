/// Orients faces: each alike with its neighbors, and those of closed skins outward.
#ifndef BALLOON_MESH_ORIENT_H
#define BALLOON_MESH_ORIENT_H

#include "mesh/edges.h"
#include "mesh/source.h"

typedef struct Orientation {
    int components; ///< connected by edges
    int flipped;    ///< faces whose corners were reversed
    int clash[2];   ///< two faces that cannot be oriented alike; NONE if all can
} Orientation;

/// Flood each component over its edges of two faces. The majority of its faces keeps its
/// orientation; then a closed component of negative volume is flipped. Faces are flipped in place
/// and keep their first corner; `edges` keeps the sides that the faces had before.
Orientation orient_faces(MeshSource* source, const Edges* edges);

#endif
