/// Sine and cosine of 2 pi k / n by + - * / only, so that every machine computes the same bits: the C
/// library's sine may differ in its last bit between machines.
#ifndef BALLOON_MESH_SHAPES_CIRCLE_H
#define BALLOON_MESH_SHAPES_CIRCLE_H

typedef struct CirclePoint {
    double cosine;
    double sine;
} CirclePoint;

/// 0 <= k < n.
CirclePoint circle_point(int k, int n);

#endif
