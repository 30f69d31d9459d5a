/// Area vector and volume of one face from its corners, in double, for the doctor and for measures
/// of a skin. measure.h has the equations.
#ifndef BALLOON_MESH_FACET_H
#define BALLOON_MESH_FACET_H

#include "mesh/mesh.h"

typedef struct Facet {
    double4 corner[4]; ///< the fourth is not set in a triangle
    int corners;       ///< 3 or 4
} Facet;

static inline Facet facet_of(const double4* point, const int face[4]) {
    Facet facet = {.corners = face_corners(face)};
    for (int k = 0; k < facet.corners; k++)
        facet.corner[k] = point[face[k]];
    return facet;
}

/// Half the cross product of a quad's diagonals, or of two sides of a triangle.
static inline double4 facet_area(const Facet* facet) {
    const double4* c = facet->corner;
    return 0.5 * (facet->corners == 4 ? dcross(c[2] - c[0], c[3] - c[1])
                                      : dcross(c[1] - c[0], c[2] - c[0]));
}

/// Six times the volume of the tetrahedron with its tip at the origin.
static inline double six_volumes(double4 a, double4 b, double4 c) {
    return ddot(a, dcross(b, c));
}

/// Volume between the face and `origin`, a quad's as the mean of its two triangulations.
static inline double facet_volume(const Facet* facet, double4 origin) {
    const double4 a = facet->corner[0] - origin;
    const double4 b = facet->corner[1] - origin;
    const double4 c = facet->corner[2] - origin;
    if (facet->corners == 3)
        return six_volumes(a, b, c) / 6;
    const double4 d = facet->corner[3] - origin;
    return (six_volumes(a, b, c) + six_volumes(a, c, d) + six_volumes(a, b, d) +
            six_volumes(b, c, d)) /
           12;
}

#endif
