/// The tangent of all forces, K = -dF/dx [N/m], for implicit methods and for spectra: a sparse
/// matrix of 3 x 3 blocks, in which each force adds the blocks of its stencils (Force.assemble),
/// and beside it what is dense, which each force multiplies by itself (Force.product).
///
/// Row after row a block of 48 bytes (float) is read once in a product: on some 11,000 vertices of
/// rubber that is half the time of going through the elements' own matrices.
#ifndef BALLOON_FORCE_TANGENT_H
#define BALLOON_FORCE_TANGENT_H

#include "force/block_matrix.h"
#include "force/force.h"

typedef struct Tangent {
    BlockMatrix matrix;
    int** slot; ///< [force_count] of each force with stencils, [count][corners][corners]: where its
                ///< blocks are, NONE for corners that are not there
} Tangent;

/// Find which particles of the body pull on each other.
void tangent_open(Tangent* tangent, const Body* body);

/// factor K at the body's present positions; `project` leaves out of the blocks what is not
/// positive.
void tangent_ready(Tangent* tangent, Body* body, double factor, bool project);

/// out = factor K d, with the factor of the last tangent_ready, plus what the caller has added to
/// the matrix.
void tangent_multiply(const Tangent* tangent, const Body* body, double factor, const real4* d,
                      real4* out);

/// The part of it that is not in the matrix: out += factor K d.
void tangent_add_dense(const Body* body, double factor, const real4* d, real4* out);

void tangent_close(Tangent* tangent);

#endif
