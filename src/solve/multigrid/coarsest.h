/// Cholesky's factor L of the coarsest matrix of multigrid.h, in tiles of eight rows and columns
/// within its envelope: a row of tiles holds what there is from its first one to the diagonal.
///
///     L_cd = (A_cd - sum over e < d  L_ce L_de^T) L_dd^-T        A = L L^T
///
/// A direction in which the matrix is not positive is left out.
#ifndef BALLOON_SOLVE_MULTIGRID_COARSEST_H
#define BALLOON_SOLVE_MULTIGRID_COARSEST_H

#include "base/lanes.h"
#include "force/block_matrix.h"

typedef struct Tile {
    real row[LANES][LANES]; ///< [row][column]
} Tile;

typedef struct Coarsest {
    int count;     ///< rows of tiles, for three numbers of each row of the matrix
    int* first;    ///< [count] first tile's column
    int* from;     ///< [count + 1] first tile
    Tile* tile;    ///< [from[count]]
    real* inverse; ///< [count * LANES] of L's diagonal, 0 of what is left out
    Tile* turned;  ///< [count] scratch: a row of tiles by [column][row]
    real* y;       ///< [count * LANES] scratch
} Coarsest;

void coarsest_open(Coarsest* coarsest, const BlockMatrix* matrix);

/// Follow the matrix's present values.
void coarsest_follow(Coarsest* coarsest, const BlockMatrix* matrix);

/// x = (L L^T)^-1 b; rows: of the matrix
void coarsest_solve(const Coarsest* coarsest, int rows, const real4* b, real4* x);

void coarsest_close(Coarsest* coarsest);

/// The loops over tiles, in as many compilations as there are kinds of machine (base/cpu.h).
typedef struct CoarsestKernels {
    /// L in place of A's lower half.
    void (*factor)(Coarsest* coarsest);

    /// y = (L L^T)^-1 y
    void (*solve)(const Coarsest* coarsest, real* y);
} CoarsestKernels;

extern const CoarsestKernels coarsest_kernels_baseline;
#ifdef __x86_64__
extern const CoarsestKernels coarsest_kernels_v3;
#endif

#endif
