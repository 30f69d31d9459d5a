#include "solve/multigrid/multigrid.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/vectors.h"

enum {
    COARSEST_ROWS = 24,           ///< a level with at most so many rows is factored
    COARSEST_ROWS_ROTATING = 400, ///< the same where nodes rotate: such a level converges better
                                  ///< factored than with one more level below it
    ROTATION_LEVEL = 2 ///< nodes rotate from this level on; on a finer one, their second row
                       ///< would cost more than it saves
};

/// The relaxation factor w. The cycle is positive where w D^-1 A has no eigenvalue of 2 or more.
/// D^-1 A of triangles has none above 3, so w < 2/3; where nodes rotate it has none above 4, since
/// D couples no translation with a rotation, so w < 1/2. [1]
static const real relaxation = (real)0.65, relaxation_rotating = (real)0.45;

static void open_level(Level* level, const BlockMatrix* matrix) {
    const int n = matrix->count;
    level->matrix = matrix;
    block_slices_make(&level->slices, matrix);
    level->x = new_array(real4, n);
    level->b = new_array(real4, n);
    level->residual = new_array(real4, n);
    level->solution = new_array(real4, n);
}

void multigrid_open(Multigrid* levels, const BlockMatrix* matrix, const real* inverse_mass) {
    *levels = (Multigrid){.count = 1};
    open_level(&levels->level[0], matrix);
    for (int l = 0; l + 1 < LEVELS_MAX; l++) {
        Level *fine = &levels->level[l], *coarse = fine + 1;
        const int rows_max = l < ROTATION_LEVEL ? COARSEST_ROWS : COARSEST_ROWS_ROTATING;
        if (fine->matrix->count <= rows_max ||
            !transfer_make(&fine->transfer, fine->matrix, l == 0 ? inverse_mass : NULL,
                           l >= ROTATION_LEVEL, l + 1 >= ROTATION_LEVEL))
            break;
        galerkin_make(&fine->galerkin, &fine->transfer, fine->matrix, &coarse->galerkin_matrix);
        open_level(coarse, &coarse->galerkin_matrix);
        coarse->position = new_array(real4, fine->transfer.aggregates);
        levels->count++;
    }
    coarsest_open(&levels->coarsest, levels->level[levels->count - 1].matrix);
}

void multigrid_update(Multigrid* levels, const real4* x, bool all_levels) {
    for (int l = 0; l < levels->count; l++) {
        Level* level = &levels->level[l];
        if (l > 0 && !all_levels)
            return;
        if (l > 0) {
            Level* fine = level - 1;
            transfer_update(&fine->transfer, l > 1 ? fine->position : x, level->position);
            galerkin_update(&fine->galerkin, &fine->transfer, fine->matrix,
                            &level->galerkin_matrix);
        }
        block_kernels()->update(
            level->matrix, l < ROTATION_LEVEL ? relaxation : relaxation_rotating, &level->slices);
    }
    coarsest_update(&levels->coarsest, levels->level[levels->count - 1].matrix);
}

/// out = an approximation of A^-1 b. Returns b . out.
static double cycle(Multigrid* levels, int l, const real4* b, real4* out) {
    Level* level = &levels->level[l];
    if (l == levels->count - 1) {
        coarsest_solve(&levels->coarsest, level->matrix->count, b, out);
        return vectors()->dot(b, out, level->matrix->count);
    }
    Level* coarse = level + 1;
    block_kernels()->smooth_first(&level->slices, b, level->x);
    block_kernels()->residual(&level->slices, b, level->x, level->residual);
    transfer_restrict(&level->transfer, level->residual, coarse->b);
    cycle(levels, l + 1, coarse->b, coarse->solution);
    transfer_prolong(&level->transfer, coarse->solution, level->x);
    return block_kernels()->smooth(&level->slices, b, level->x, out);
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
        free(level->residual);
        free(level->solution);
        free(level->position);
        transfer_free(&level->transfer);
        galerkin_free(&level->galerkin);
        block_matrix_free(&level->galerkin_matrix);
    }
    coarsest_close(&levels->coarsest);
    *levels = (Multigrid){0};
}
