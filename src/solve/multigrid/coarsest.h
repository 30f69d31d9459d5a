/// Cholesky factor L of the coarsest matrix of multigrid.h, in tiles of 8 x 8 numbers within its
/// envelope: each row of tiles is stored from its first nonzero tile to the diagonal.
///
///     L_cd = (A_cd - sum over e < d  L_ce L_de^T) L_dd^-T        A = L L^T
///
/// A direction along which the matrix is not positive is left out: its row of L^-1 is zero.
///
/// It replaces a library: CHOLMOD 3 factors in double only, and LAPACK's bits differ from machine
/// to machine. With CHOLMOD (simplicial, double) on this level alone, a frame of the rubber teddy
/// takes 1.1 to 1.2 times as long (the measurement of multigrid.h).
#ifndef BALLOON_SOLVE_MULTIGRID_COARSEST_H
#define BALLOON_SOLVE_MULTIGRID_COARSEST_H

#include "base/vec.h"
#include "force/block_matrix.h"

typedef struct Tile {
    real row[LANES][LANES]; ///< [row][column]
} Tile;

typedef struct Coarsest {
    int count;        ///< rows of tiles; a row of the matrix is three rows of numbers
    int* first;       ///< [count] column of each row's first tile
    int* from;        ///< [count + 1] index of each row's first tile
    Tile* tile;       ///< [from[count]]
    real* inverse;    ///< [count * LANES] 1 / L's diagonal; 0 for a direction that is left out
    Tile* transposed; ///< [count] scratch: a row of tiles, transposed
    real* y;          ///< [count * LANES] scratch
} Coarsest;

void coarsest_open(Coarsest* coarsest, const BlockMatrix* matrix);

/// Factor the matrix's present values.
void coarsest_update(Coarsest* coarsest, const BlockMatrix* matrix);

/// x = (L L^T)^-1 b, [rows] of the matrix
void coarsest_solve(const Coarsest* coarsest, int rows, const real4* b, real4* x);

void coarsest_close(Coarsest* coarsest);

/// The loops over tiles, compiled once for each kind of machine (base/cpu.h).
typedef struct CoarsestKernels {
    /// Replace A's lower triangle by L.
    void (*factor)(Coarsest* coarsest);

    /// y = (L L^T)^-1 y
    void (*solve)(const Coarsest* coarsest, real* y);
} CoarsestKernels;

extern const CoarsestKernels coarsest_kernels_baseline;
#ifdef __x86_64__
extern const CoarsestKernels coarsest_kernels_v3;
#endif

#endif
