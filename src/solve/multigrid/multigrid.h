/// An approximate inverse of a sparse matrix of blocks, for conjugate gradients: one cycle through
/// ever coarser skins.
///
///     x  = w D^-1 b                         smooth: what varies from particle to particle
///     x += P (P^T A P)^-1 P^T (b - A x)     the rest, on a coarser level, by the same way
///     x += w D^-1 (b - A x)                 smooth again, so that the whole is symmetric
///
/// D are the diagonal blocks. P is smoothed aggregation on the graph of the matrix, with nodes that
/// turn on the coarser levels (transfer.h). Who belongs to whom rests on who pulls on whom alone,
/// and is found once; P^T A P follows the tangent and the places. The coarsest level is solved by
/// Cholesky's method.
///
/// Positive definite where the matrix is.
#ifndef BALLOON_SOLVE_MULTIGRID_MULTIGRID_H
#define BALLOON_SOLVE_MULTIGRID_MULTIGRID_H

#include <stdbool.h>

#include "force/block_slices.h"
#include "solve/multigrid/coarsest.h"
#include "solve/multigrid/galerkin.h"

typedef struct Level {
    const BlockMatrix* matrix;
    BlockSlices slices; ///< the matrix for products, and w D^-1
    real4* b;           ///< [rows] the right side; the finest's is the caller's
    real4* x;           ///< [rows] nearer and nearer
    real4* left;        ///< [rows] b - A x
    real4* answer;      ///< [rows] the finest's is the caller's
    real4* place;       ///< [nodes] where each node is; the finest's are the caller's [m]
    Transfer transfer;  ///< to the next level; empty on the coarsest
    Galerkin galerkin;  ///< and its matrix
    BlockMatrix own;    ///< of all but the finest
} Level;

enum { LEVELS_MOST = 12 };

typedef struct Multigrid {
    int count;
    Level level[LEVELS_MOST];
    Coarsest coarsest;
} Multigrid;

/// Find the levels of a matrix, which stays the caller's. inverse_mass: 0 holds a row.
void multigrid_open(Multigrid* levels, const BlockMatrix* matrix, const real* inverse_mass);

/// Follow the matrix's present values, and the particles' places x: on all levels, or on the finest
/// alone, which is cheaper and often enough.
void multigrid_ready(Multigrid* levels, const real4* x, bool all);

/// out = one cycle for the right side b. Returns b . out.
double multigrid_apply(Multigrid* levels, const real4* b, real4* out);

/// out = the matrix, as it was when the levels last followed it, times d
void multigrid_multiply(const Multigrid* levels, const real4* d, real4* out);

void multigrid_close(Multigrid* levels);

#endif
