/// The coarser level's matrix P^T A P (Galerkin's), with P of transfer.h and A symmetric. For each
/// block A_ij, each term a of node i and each term b of node j contribute
///
///     T T  w_a w_b A     T R  w_a A E_b     R T  w_b E_a^T A     R R  E_a^T A E_b,   E d = d x m
///
/// to the coarser block of their aggregates. Only A's blocks on and above the diagonal are used;
/// the transposed contributions are added at the end.
#ifndef BALLOON_SOLVE_MULTIGRID_GALERKIN_H
#define BALLOON_SOLVE_MULTIGRID_GALERKIN_H

#include "solve/multigrid/transfer.h"

typedef struct Galerkin {
    int* target; ///< [contributions] coarser block that each is added to, in the order of the loops
    int* mirror; ///< [coarser blocks] index of the transposed block
} Galerkin;

/// Make the coarser matrix's sparsity pattern, and find the block of each contribution.
void galerkin_make(Galerkin* galerkin, const Transfer* transfer, const BlockMatrix* matrix,
                   BlockMatrix* coarse);

/// coarse = P^T matrix P
void galerkin_update(const Galerkin* galerkin, const Transfer* transfer, const BlockMatrix* matrix,
                     BlockMatrix* coarse);

void galerkin_free(Galerkin* galerkin);

#endif
