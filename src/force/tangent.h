/// The tangent of all forces, K = -df/dx [N/m], for implicit methods and for spectra: a sparse
/// matrix of 3 x 3 blocks, to which each force adds the blocks of its stencils (Force.assemble). A
/// force with a dense part multiplies it by a vector itself (Force.product).
///
/// A product reads each block of 48 bytes (float) once, row after row: on some 11,000 vertices of
/// rubber it takes half the time of one that goes through the elements' own matrices.
#ifndef BALLOON_FORCE_TANGENT_H
#define BALLOON_FORCE_TANGENT_H

#include "force/block_matrix.h"
#include "force/force.h"

typedef struct Tangent {
    BlockMatrix matrix;
    int**
        block_at; ///< [force_count] of each force with stencils, [count][corners][corners]: index of its
                  ///< its blocks in the matrix, NONE for missing corners
} Tangent;

/// Find the matrix's sparsity pattern from the stencils of all forces.
void tangent_open(Tangent* tangent, const Body* body);

/// Compute factor K at the body's present positions; with `project`, each stencil's matrix is
/// replaced by its positive semidefinite part.
void tangent_update(Tangent* tangent, Body* body, double factor, bool project);

/// out = factor K d, with the factor of the last tangent_update, plus the product of whatever the
/// caller has added to the matrix.
void tangent_multiply(const Tangent* tangent, const Body* body, double factor, const real4* d,
                      real4* out);

/// out += factor K d for the dense parts of K, which are not in the matrix.
void tangent_add_dense(const Body* body, double factor, const real4* d, real4* out);

void tangent_close(Tangent* tangent);

#endif
