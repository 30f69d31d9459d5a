#include "solve/multigrid/multigrid.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/vectors.h"

enum {
    COARSEST = 24,          ///< rows that are few enough for a full matrix
    COARSEST_TURNING = 400, ///< of nodes that turn, whose level is worth more than one below it
    TURNING_LEVEL = 2       ///< from here on nodes turn: before, twice the rows cost too much
};

/// w: below 2/3, for D^-1 A of triangles is at most 3; where nodes turn it is at most 4, for D
/// takes motions and turns by themselves. [1]
static const real damped = (real)0.65, damped_turning = (real)0.45;

static void open_level(Level* level, const BlockMatrix* matrix) {
    const int n = matrix->count;
    level->matrix = matrix;
    block_slices_make(&level->slices, matrix);
    level->x = new_array(real4, n);
    level->b = new_array(real4, n);
    level->left = new_array(real4, n);
    level->answer = new_array(real4, n);
}

void multigrid_open(Multigrid* levels, const BlockMatrix* matrix, const real* inverse_mass) {
    *levels = (Multigrid){.count = 1};
    open_level(&levels->level[0], matrix);
    for (int l = 0; l + 1 < LEVELS_MOST; l++) {
        Level *fine = &levels->level[l], *coarse = fine + 1;
        const int enough = l < TURNING_LEVEL ? COARSEST : COARSEST_TURNING;
        if (fine->matrix->count <= enough ||
            !transfer_make(&fine->transfer, fine->matrix, l == 0 ? inverse_mass : NULL,
                           l >= TURNING_LEVEL, l + 1 >= TURNING_LEVEL))
            break;
        galerkin_make(&fine->galerkin, &fine->transfer, fine->matrix, &coarse->own);
        open_level(coarse, &coarse->own);
        coarse->place = new_array(real4, fine->transfer.groups);
        levels->count++;
    }
    coarsest_open(&levels->coarsest, levels->level[levels->count - 1].matrix);
}

void multigrid_ready(Multigrid* levels, const real4* x, bool all) {
    for (int l = 0; l < levels->count; l++) {
        Level* level = &levels->level[l];
        if (l > 0 && !all)
            return;
        if (l > 0) {
            Level* fine = level - 1;
            transfer_place(&fine->transfer, l > 1 ? fine->place : x, level->place);
            galerkin_follow(&fine->galerkin, &fine->transfer, fine->matrix, &level->own);
        }
        block_kernels()->copy(level->matrix, l < TURNING_LEVEL ? damped : damped_turning,
                              &level->slices);
    }
    coarsest_follow(&levels->coarsest, levels->level[levels->count - 1].matrix);
}

/// out = nearly A^-1 b. Returns b . out.
static double cycle(Multigrid* levels, int l, const real4* b, real4* out) {
    Level* level = &levels->level[l];
    if (l == levels->count - 1) {
        coarsest_solve(&levels->coarsest, level->matrix->count, b, out);
        return vectors()->dot(b, out, level->matrix->count);
    }
    Level* coarse = level + 1;
    block_kernels()->begin(&level->slices, b, level->x);
    block_kernels()->remain(&level->slices, b, level->x, level->left);
    transfer_restrict(&level->transfer, level->left, coarse->b);
    cycle(levels, l + 1, coarse->b, coarse->answer);
    transfer_prolong(&level->transfer, coarse->answer, level->x);
    return block_kernels()->relax(&level->slices, b, level->x, out);
}

double multigrid_apply(Multigrid* levels, const real4* b, real4* out) {
    return cycle(levels, 0, b, out);
}

void multigrid_multiply(const Multigrid* levels, const real4* d, real4* out) {
    block_kernels()->multiply(&levels->level[0].slices, d, out);
}

void multigrid_close(Multigrid* levels) {
    for (int l = 0; l < levels->count; l++) {
        Level* level = &levels->level[l];
        block_slices_free(&level->slices);
        free(level->x);
        free(level->b);
        free(level->left);
        free(level->answer);
        free(level->place);
        transfer_free(&level->transfer);
        galerkin_free(&level->galerkin);
        block_matrix_free(&level->own);
    }
    coarsest_close(&levels->coarsest);
    *levels = (Multigrid){0};
}
