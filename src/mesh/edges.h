/// The edges of any set of faces, sound or not: what the doctor examines and a mesh is made from.
///
/// A face's side k runs from its corner k to the next one; sides are numbered 4 * face + k.
/// All sides between the same two points are one edge, whichever way they run:
///
///         d --- c --- f
///         |  0  |  1  |      side 1 of face 0 (b to c) and side 3 of face 1 (c to b)
///         a --- b --- e      are one edge of two faces
#ifndef BALLOON_MESH_EDGES_H
#define BALLOON_MESH_EDGES_H

#include "mesh/mesh.h"

typedef struct Edges {
    int count;
    int (*end)[2];  ///< [count] the two points, as the first side that uses the edge runs
    int (*side)[2]; ///< [count] the first two sides, NONE for no second
    int* sides;     ///< [count] how many sides there are: one at a rim, two inside
    int* of_side;   ///< [4 * face_count] the edge of each side, NONE for a triangle's fourth
} Edges;

/// Edges are numbered in order of first use by a face. Time is linear in the faces at any valence.
void edges_find(Edges* edges, const int (*face)[4], int face_count, int point_count);

void edges_free(Edges* edges);

static inline int side_start(const int (*face)[4], int side) {
    return face[side / 4][side % 4];
}

static inline int side_end(const int (*face)[4], int side) {
    const int* corner = face[side / 4];
    return corner[(side % 4 + 1) % face_corners(corner)];
}

#endif
