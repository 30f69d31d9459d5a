/// A coarser level's matrix P^T A P, with P of transfer.h and A symmetric: each block of A goes, by
/// each part of its row's node and of its column's, to one of the coarser matrix,
///
///     T T  w_a w_b A     T R  w_a A E_b     R T  w_b E_a^T A     R R  E_a^T A E_b,   E d = d x m
///
/// Only blocks at or above the diagonal are taken, and what they gave is mirrored.
#ifndef BALLOON_SOLVE_MULTIGRID_GALERKIN_H
#define BALLOON_SOLVE_MULTIGRID_GALERKIN_H

#include "solve/multigrid/transfer.h"

typedef struct Galerkin {
    int* slot;   ///< where each part goes in the coarser matrix, in the order of the loops
    int* mirror; ///< [coarser blocks] the one across the diagonal
} Galerkin;

/// Find where what goes, and which blocks the coarser matrix has.
void galerkin_make(Galerkin* galerkin, const Transfer* transfer, const BlockMatrix* matrix,
                   BlockMatrix* coarse);

/// coarse = P^T matrix P
void galerkin_follow(const Galerkin* galerkin, const Transfer* transfer, const BlockMatrix* matrix,
                     BlockMatrix* coarse);

void galerkin_free(Galerkin* galerkin);

#endif
