/// The edges of any set of faces, manifold or not: for the doctor and for mesh_make.
///
/// A face's side k (a half-edge) runs from its corner k to the next one; its number is 4 * face +
/// k. All sides between the same two points are one edge, in either direction:
///
///         d --- c --- f
///         |  0  |  1  |      side 1 of face 0 (b to c) and side 3 of face 1 (c to b)
///         a --- b --- e      are one edge of two faces
#ifndef BALLOON_MESH_EDGES_H
#define BALLOON_MESH_EDGES_H

#include "mesh/mesh.h"

typedef struct Edges {
    int count;
    int (*end)[2];  ///< [count] the two points, in the direction of its first side
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
