/// The preconditioner of Newton's linear equations: one V-cycle of algebraic multigrid for a sparse
/// symmetric matrix A of 3 x 3 blocks.
///
///     x  = w D^-1 b                         smooth: reduce errors that vary between neighbors
///     x += P (P^T A P)^-1 P^T (b - A x)     correct the rest on the next coarser level, recursively
///     x += w D^-1 (b - A x)                 smooth again, which makes the cycle symmetric
///
/// D holds A's diagonal blocks, w is the relaxation factor. P comes from smoothed aggregation
/// (transfer.h); on the coarser levels nodes also rotate. The aggregates depend on A's sparsity
/// pattern only and are found once; P^T A P follows A's values and the particles' positions. The
/// coarsest level is solved by Cholesky factorization (coarsest.h). The cycle is positive definite
/// where A is.
///
/// Measured against simpler ways: one frame of the rubber teddy (11,120 particles, 33,360 unknowns,
/// float, one thread), 3 Newton iterations with conjugate gradients to 1e-3,
/// `balloon bench table1 --only teddy --quick`. Time relative to this cycle, and Hessian-vector
/// products of a frame:
///
///     this cycle                                            1      33
///     block Jacobi (D^-1 alone)                             3.2   592
///     CHOLMOD, double, simplicial, factored as seldom       6.3     8
///     CHOLMOD, double, supernodal, factored as seldom       6.2     8
///
/// With the step's equation solved to 1e-6, block Jacobi takes 2.4 times as long (139 products for
/// 5.8). The direct factors are those of the sparse part; the gas's dense part needs iterations.
#ifndef BALLOON_SOLVE_MULTIGRID_MULTIGRID_H
#define BALLOON_SOLVE_MULTIGRID_MULTIGRID_H

#include <stdbool.h>

#include "force/block_slices.h"
#include "solve/multigrid/coarsest.h"
#include "solve/multigrid/galerkin.h"

typedef struct Level {
    const BlockMatrix* matrix;
    BlockSlices slices;          ///< the matrix for products, and w D^-1
    real4* b;                    ///< [rows] right-hand side; on the finest level the caller's
    real4* x;                    ///< [rows] iterate
    real4* residual;             ///< [rows] b - A x
    real4* solution;             ///< [rows] on the finest level the caller's
    real4* position;             ///< [nodes] on the finest level the caller's [m]
    Transfer transfer;           ///< P from the next coarser level; empty on the coarsest
    Galerkin galerkin;           ///< computes that level's matrix from this one's
    BlockMatrix galerkin_matrix; ///< P^T A P of the next finer level; empty on the finest
} Level;

enum { LEVELS_MAX = 12 };

typedef struct Multigrid {
    int count;
    Level level[LEVELS_MAX];
    Coarsest coarsest;
} Multigrid;

/// Find the levels of a matrix, which the caller keeps. A row of inverse_mass 0 is held fixed.
void multigrid_open(Multigrid* levels, const BlockMatrix* matrix, const real* inverse_mass);

/// Update to the matrix's present values and the particles' positions x: on all levels, or on the
/// finest alone, which is cheaper and often good enough.
void multigrid_update(Multigrid* levels, const real4* x, bool all_levels);

/// out = one cycle for the right-hand side b. Returns b . out.
double multigrid_apply(Multigrid* levels, const real4* b, real4* out);

/// out = A d, with A as of the last multigrid_update
void multigrid_multiply(const Multigrid* levels, const real4* d, real4* out);

void multigrid_close(Multigrid* levels);

#endif
