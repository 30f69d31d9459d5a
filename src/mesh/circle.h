/// The point k/n of the way around the unit circle, by arithmetic that is the same everywhere:
/// the C library's sine may differ in its last bit from one machine to the next.
#ifndef BALLOON_MESH_CIRCLE_H
#define BALLOON_MESH_CIRCLE_H

typedef struct CirclePoint {
    double cosine;
    double sine;
} CirclePoint;

/// 0 <= k < n.
CirclePoint circle_point(int k, int n);

#endif
