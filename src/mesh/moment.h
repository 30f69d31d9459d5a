/// First moment of the enclosed volume about a horizontal plane, for buoyancy.
///
///     M = integral of y dV = sum over triangles of N_y Q / 24
///     N = (b - a) x (c - a),  Q = ya^2 + yb^2 + yc^2 + ya yb + yb yc + yc ya
///
/// by the divergence theorem, with heights y above `level`. A quad contributes the mean of its two
/// triangulations, as in its volume (mesh/measure.h). Closed meshes only.
#ifndef BALLOON_MESH_MOMENT_H
#define BALLOON_MESH_MOMENT_H

#include "mesh/mesh.h"

/// [unit^4]
double moment_of_height(const Mesh* mesh, const real4* x, double level);

/// out += factor dM/dx.
void moment_add_gradient(const Mesh* mesh, const real4* x, double level, real factor, real4* out);

/// out += factor (d2M/dx2) d. Returns dM/dx . d.
double moment_add_product(const Mesh* mesh, const real4* x, double level, const real4* d,
                          real factor, real4* out);

#endif
