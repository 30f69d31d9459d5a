/// When a moving point crosses a moving triangle, in double; and a point's winding number in a closed
/// skin.
#ifndef BALLOON_CONTACT_TRIANGLE_PATH_H
#define BALLOON_CONTACT_TRIANGLE_PATH_H

#include "body/body.h"

/// The first time in (0, 1] at which the point p + t dp lies in the triangle with corners
/// a[k] + t da[k]; 2 where it never does. Both paths are straight lines, so the point's height over
/// the triangle's plane is a cubic in t, bisected on its monotone intervals.
double triangle_crossing_time(double4 p, double4 dp, const double4 a[3], const double4 da[3]);

/// Winding number of a closed skin around a point: 1 inside, 0 outside, if it does not overlap.
/// Sum of the triangles' solid angles over 4 pi.
/// Source: A. van Oosterom, J. Strackee, The solid angle of a plane triangle, IEEE Trans. Biomed.
/// Eng. 30, 1983.
double winding_number(const Mesh* mesh, const real4* x, double4 point);

#endif
