/// Area, volume and volume gradient of a skin at the particles' present positions.
///
/// A quad's volume is the mean of its two triangulations, so that neither diagonal is preferred.
/// With D = (c - a) x (d - b), twice the area vector, and N_k = the cross product of the two edges
/// that leave corner k (N_a + N_c = N_b + N_d = D), translation-invariant on a closed mesh:
///
///     dV/dx_k = (D + N_k) / 12          per quad and corner; on a parallelogram D/8,
///                                       a quarter of the area vector
///     dV/dx_k = N / 6                   per triangle, N twice its area vector
///
/// An open mesh encloses no volume: its gradient is the quarter area vector D/8 itself (and N/6).
/// Area is the sum of the lengths of the faces' area vectors, |D|/2 and |N|/2.
#ifndef BALLOON_MESH_MEASURE_H
#define BALLOON_MESH_MEASURE_H

#include "mesh/mesh.h"

/// [unit^2] in double.
double measure_area(const Mesh* mesh, const real4* x);

/// [unit^3] in double, from a local origin, so that a far-away skin loses no digits; 0 when open.
double measure_volume(const Mesh* mesh, const real4* x);

/// gradient[i] = dV/dx_i, [point_count], overwritten. Returns the area as measure_area does.
double measure_volume_gradient(const Mesh* mesh, const real4* x, real4* gradient);

/// dV/dx_i of one point, in double.
double4 measure_volume_gradient_at(const Mesh* mesh, const real4* x, int point);

/// out += factor (d2V/dx2) d, the change of the gradient when the points move by d.
void measure_volume_product(const Mesh* mesh, const real4* x, const real4* d, real factor,
                            real4* out);

#endif
