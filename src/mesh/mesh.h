/// The skin's topology and rest shape: points joined by quads, triangles or both. It is constant
/// after mesh_make.
///
/// Points are numbered for locality (mesh/reorder.h). Everything that leaves the program (particle
/// numbers in scenes and logs, OBJ, hash) uses the loaded order, the order of first use by a face:
///
///     loaded[i]   loaded number of point i
///     inside[k]   the point whose loaded number is k
///
/// A face's corners run counter-clockwise seen from outside; a triangle's fourth corner is -1.
/// An open mesh has edges with one face, its rim.
#ifndef BALLOON_MESH_MESH_H
#define BALLOON_MESH_MESH_H

#include <stdbool.h>

#include "base/fault.h"
#include "base/vec.h"

enum { NONE = -1 }; ///< no corner, no face

typedef struct Mesh {
    int point_count;
    int face_count;
    int edge_count;
    int triangle_count;

    double4* point;       ///< [point_count] rest position, in the file's unit
    int (*face)[4];       ///< [face_count] corners, in loaded face order
    int (*edge)[2];       ///< [edge_count] each pair of joined points once, in order of first use
    int (*edge_face)[2];  ///< [edge_count] the one or two faces of an edge, NONE for no second
    int (*triangle)[3];   ///< [triangle_count] the faces, quads split along their shorter diagonal
    int* point_face_from; ///< [point_count + 1] where point i's faces begin in point_face
    int* point_face;      ///< faces around each point
    int* point_edge_from; ///< [point_count + 1] where point i's edges begin in point_edge
    int* point_edge;      ///< edges at each point; their number is the valence
    int* loaded;          ///< [point_count] loaded number of point i
    int* inside;          ///< [point_count] the inverse of loaded
    bool closed;          ///< no rim
} Mesh;

/// Make the mesh from raw arrays in loaded order: number the points for locality, find edges and
/// adjacency in time linear in the mesh. Faces must have passed the doctor: distinct corners, at
/// most two faces an edge, consistent winding. point: [point_count], face: [face_count].
void mesh_make(Mesh* mesh, const double4* point, int point_count, const int (*face)[4],
               int face_count);

/// The other end of an edge.
static inline int mesh_across(const Mesh* mesh, int edge, int point) {
    return mesh->edge[edge][0] + mesh->edge[edge][1] - point;
}

static inline int face_corners(const int face[4]) {
    return face[3] == NONE ? 3 : 4;
}

void mesh_free(Mesh* mesh);

#endif
