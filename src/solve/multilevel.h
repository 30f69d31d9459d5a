/// An approximate inverse of a sparse matrix of blocks, for conjugate gradients: one cycle through
/// ever coarser skins.
///
///     x  = w D^-1 b                         smooth: what varies from particle to particle
///     x += P (P^T A P)^-1 P^T (b - A x)     the rest, on a coarser level, by the same way
///     x += w D^-1 (b - A x)                 smooth again, so that the whole is symmetric
///
/// D are the diagonal blocks. P is smoothed aggregation (P. Vanek, J. Mandel, M. Brezina, Algebraic
/// multigrid by smoothed aggregation, 1996) on the graph of the matrix: particles join into groups
/// of neighbours, and a particle at a group's edge belongs in part to the next. It is the same for
/// x, y and z and rests on who pulls on whom alone, so it is found once; only P^T A P follows the
/// tangent. The coarsest level is solved by Cholesky's method.
///
/// Positive definite where the matrix is.
#ifndef BALLOON_SOLVE_MULTILEVEL_H
#define BALLOON_SOLVE_MULTILEVEL_H

#include <stdbool.h>

#include "force/block_slices.h"

/// P of a level: row i's value is sum of weight times the coarse value.
typedef struct Transfer {
    int* from;         ///< [rows + 1]
    int* coarse;       ///< [from[rows]]
    real* weight;      ///< [from[rows]] they add up to 1, or to 0 where the row is held
    int* back_from;    ///< [coarse rows + 1] the same by coarse rows, for P^T
    int* fine;         ///< [from[rows]]
    real* back_weight; ///< [from[rows]]
} Transfer;

typedef struct Level {
    const BlockMatrix* matrix;
    BlockSlices slices; ///< the matrix for products, and w D^-1
    real4* x;           ///< [rows] the level's answer
    real4* b;           ///< [rows] the level's right side; the finest's is the caller's
    real4* left;        ///< [rows] b - A x
    Transfer transfer;  ///< to the next level; empty on the coarsest
    int* slot;          ///< where each part of P^T A P goes in the next level's matrix
    BlockMatrix own;    ///< of all but the finest
} Level;

enum { LEVELS_MOST = 12 };

typedef struct Multilevel {
    int count;
    Level level[LEVELS_MOST];
    double* factor;  ///< [3 rows][3 rows] of the coarsest matrix, lower triangle
    double* scratch; ///< [3 rows] of the coarsest
} Multilevel;

/// Find the levels of a matrix, which stays the caller's. inverse_mass: 0 holds a row.
void multilevel_open(Multilevel* levels, const BlockMatrix* matrix, const real* inverse_mass);

/// Follow the matrix's present values: on all levels, or on the finest alone, which is cheaper and
/// often enough.
void multilevel_ready(Multilevel* levels, bool all);

/// out = one cycle for the right side b
void multilevel_apply(Multilevel* levels, const real4* b, real4* out);

/// out = the matrix, as it was when the levels last followed it, times d
void multilevel_multiply(const Multilevel* levels, const real4* d, real4* out);

void multilevel_close(Multilevel* levels);

#endif
