#include "solve/multigrid/coarsest.h"

#include <stdlib.h>
#include <string.h>

#include "base/cpu.h"
#include "base/memory.h"

static const CoarsestKernels* best_kernels(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return &coarsest_kernels_v3;
#endif
    return &coarsest_kernels_baseline;
}

void coarsest_open(Coarsest* coarsest, const BlockMatrix* matrix) {
    const int count = (3 * matrix->count + LANES - 1) / LANES;
    *coarsest = (Coarsest){
        .count = count,
        .first = new_array(int, count),
        .from = new_array(int, count + 1),
        .inverse = new_array(real, count * LANES),
        .transposed = new_array(Tile, count),
        .y = new_array(real, count * LANES),
    };
    for (int c = 0; c < count; c++)
        coarsest->first[c] = c;
    for (int i = 0; i < matrix->count; i++)
        for (int k = matrix->from[i]; k < matrix->from[i + 1]; k++) {
            const int column = 3 * matrix->column[k] / LANES;
            for (int c = 3 * i / LANES; c <= (3 * i + 2) / LANES; c++)
                coarsest->first[c] = column < coarsest->first[c] ? column : coarsest->first[c];
        }
    for (int c = 0; c < count; c++)
        coarsest->from[c + 1] = coarsest->from[c] + c + 1 - coarsest->first[c];
    coarsest->tile = new_array(Tile, coarsest->from[count]);
}

void coarsest_update(Coarsest* coarsest, const BlockMatrix* matrix) {
    memset(coarsest->tile, 0, (size_t)coarsest->from[coarsest->count] * sizeof *coarsest->tile);
    for (int row = 0; row < 3 * matrix->count; row++) {
        const int i = row / 3, c = row / LANES;
        Tile* tile = &coarsest->tile[coarsest->from[c] - coarsest->first[c]];
        for (int k = matrix->from[i]; k < matrix->from[i + 1]; k++)
            for (int n = 0; n < 3; n++) {
                const int column = 3 * matrix->column[k] + n;
                if (column <= row)
                    tile[column / LANES].row[row % LANES][column % LANES] =
                        matrix->value[k].column[n][row % 3];
            }
    }
    best_kernels()->factor(coarsest);
}

void coarsest_solve(const Coarsest* coarsest, int rows, const real4* b, real4* x) {
    real* y = coarsest->y;
    for (int i = 0; i < 3 * rows; i++)
        y[i] = b[i / 3][i % 3];
    best_kernels()->solve(coarsest, y);
    for (int i = 0; i < rows; i++)
        x[i] = (real4){y[3 * i], y[3 * i + 1], y[3 * i + 2], 0};
}

void coarsest_close(Coarsest* coarsest) {
    free(coarsest->first);
    free(coarsest->from);
    free(coarsest->tile);
    free(coarsest->inverse);
    free(coarsest->transposed);
    free(coarsest->y);
    *coarsest = (Coarsest){0};
}
