/// The corners of triangles around each point. Corner c is number c % 3 of triangle c / 3.
#ifndef BALLOON_MESH_POINT_CORNERS_H
#define BALLOON_MESH_POINT_CORNERS_H

#include "mesh/mesh.h"

typedef struct PointCorners {
    int* from;   ///< [points + 1] those of point i are corner[from[i]] … corner[from[i + 1] - 1]
    int* corner; ///< [3 * triangles] in ascending order around each point
} PointCorners;

PointCorners point_corners_open(const Mesh* mesh);
void point_corners_close(PointCorners* corners);

static inline bool triangle_has(const int triangle[3], int point) {
    return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

#endif
