#include "solve/multilevel.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/mesh.h"

enum {
    COARSEST = 24, ///< rows that are few enough for a full matrix
    TURNS = 2      ///< through what is coarser: cheap there, and a quarter fewer cycles in all
};

static const real damped = (real)0.65;   ///< [1] w: below 2/3, for D^-1 A of triangles is at most 3
static const real smoothing = (real)0.9; ///< [1] 4/3 over the largest of the graph's Laplacian

/// Groups of neighbours: group[i] of each row. Returns their number.
static int aggregate(const BlockMatrix* matrix, int* group) {
    const int n = matrix->count;
    int groups = 0;
    for (int i = 0; i < n; i++)
        group[i] = NONE;

    // a row whose neighbours are all free, and these neighbours
    for (int i = 0; i < n; i++) {
        bool all = true;
        for (int k = matrix->from[i]; all && k < matrix->from[i + 1]; k++)
            all = group[matrix->column[k]] == NONE;
        if (!all)
            continue;
        for (int k = matrix->from[i]; k < matrix->from[i + 1]; k++)
            group[matrix->column[k]] = groups;
        groups++;
    }
    // what is left lies between groups, and joins one; -2 - g until all have looked
    for (int i = 0; i < n; i++)
        for (int k = matrix->from[i]; group[i] == NONE && k < matrix->from[i + 1]; k++)
            if (group[matrix->column[k]] >= 0)
                group[i] = -2 - group[matrix->column[k]];
    for (int i = 0; i < n; i++)
        if (group[i] < NONE)
            group[i] = -2 - group[i];
        else if (group[i] == NONE)
            group[i] = groups++;
    return groups;
}

/// weight of `coarse` in the row that begins at `begin` grows.
static void add_weight(Transfer* transfer, int begin, int* end, int coarse, real weight) {
    int k = begin;
    while (k < *end && transfer->coarse[k] != coarse)
        k++;
    if (k == *end) {
        transfer->coarse[k] = coarse;
        transfer->weight[k] = 0;
        (*end)++;
    }
    transfer->weight[k] += weight;
}

/// P = (1 - s) P0 + s (mean of the neighbours' P0), P0 being 1 in a row's own group.
static void make_transfer(const BlockMatrix* matrix, const int* group, const real* inverse_mass,
                          Transfer* transfer) {
    const int n = matrix->count;
    transfer->from = new_array(int, n + 1);
    transfer->coarse = new_array(int, matrix->from[n]);
    transfer->weight = new_array(real, matrix->from[n]);
    for (int i = 0; i < n; i++) {
        const int begin = transfer->from[i];
        int end = begin;
        const int neighbours = matrix->from[i + 1] - matrix->from[i] - 1;
        if (!inverse_mass || inverse_mass[i] > 0) {
            add_weight(transfer, begin, &end, group[i], neighbours > 0 ? 1 - smoothing : 1);
            for (int k = matrix->from[i] + 1; k < matrix->from[i + 1]; k++)
                add_weight(transfer, begin, &end, group[matrix->column[k]],
                           smoothing / (real)neighbours);
        }
        transfer->from[i + 1] = end;
    }
}

/// The same by coarse rows, fine ones in their order.
static void turn_over(Transfer* transfer, int rows, int groups) {
    const int parts = transfer->from[rows];
    transfer->back_from = new_array(int, groups + 1);
    transfer->fine = new_array(int, parts);
    transfer->back_weight = new_array(real, parts);
    for (int a = 0; a < parts; a++)
        transfer->back_from[transfer->coarse[a] + 1]++;
    for (int g = 0; g < groups; g++)
        transfer->back_from[g + 1] += transfer->back_from[g];
    int* at = new_array(int, groups);
    memcpy(at, transfer->back_from, (size_t)groups * sizeof *at);
    for (int i = 0; i < rows; i++)
        for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++) {
            const int k = at[transfer->coarse[a]]++;
            transfer->fine[k] = i;
            transfer->back_weight[k] = transfer->weight[a];
        }
    free(at);
}

/// Where each part w_a w_b A_ij of P^T A P goes: (a, b) for each block (i, j), each a of row i and
/// each b of row j, in this order. Returns how many parts there are; with pair NULL, counts only.
static int collect(const BlockMatrix* matrix, const Transfer* transfer, int (*pair)[2]) {
    int count = 0;
    for (int i = 0; i < matrix->count; i++)
        for (int k = matrix->from[i]; k < matrix->from[i + 1]; k++) {
            const int j = matrix->column[k];
            for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
                for (int b = transfer->from[j]; b < transfer->from[j + 1]; b++, count++)
                    if (pair) {
                        pair[count][0] = transfer->coarse[a];
                        pair[count][1] = transfer->coarse[b];
                    }
        }
    return count;
}

static void make_coarse(Level* fine, int groups, BlockMatrix* coarse) {
    const int parts = collect(fine->matrix, &fine->transfer, NULL);
    int(*pair)[2] = new_array(int[2], parts);
    collect(fine->matrix, &fine->transfer, pair);
    block_matrix_make(coarse, groups, (const int(*)[2])pair, parts);
    fine->slot = new_array(int, parts);
    for (int p = 0; p < parts; p++)
        fine->slot[p] = block_matrix_find(coarse, pair[p][0], pair[p][1]);
    free(pair);
}

/// coarse = P^T A P
static void follow(const Level* fine, BlockMatrix* coarse) {
    const BlockMatrix* matrix = fine->matrix;
    const Transfer* transfer = &fine->transfer;
    const int* slot = fine->slot;
    block_matrix_clear(coarse);
    for (int i = 0; i < matrix->count; i++)
        for (int k = matrix->from[i]; k < matrix->from[i + 1]; k++) {
            const int j = matrix->column[k];
            const Block block = matrix->value[k];
            for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
                for (int b = transfer->from[j]; b < transfer->from[j + 1]; b++) {
                    Block* to = &coarse->value[*slot++];
                    const real weight = transfer->weight[a] * transfer->weight[b];
                    for (int c = 0; c < 3; c++)
                        to->column[c] += weight * block.column[c];
                }
        }
}

static void open_level(Level* level, const BlockMatrix* matrix) {
    const int n = matrix->count;
    level->matrix = matrix;
    block_slices_make(&level->slices, matrix);
    level->x = new_array(real4, n);
    level->b = new_array(real4, n);
    level->left = new_array(real4, n);
}

void multilevel_open(Multilevel* levels, const BlockMatrix* matrix, const real* inverse_mass) {
    *levels = (Multilevel){.count = 1};
    open_level(&levels->level[0], matrix);
    while (levels->count < LEVELS_MOST) {
        Level *fine = &levels->level[levels->count - 1], *coarse = fine + 1;
        const int n = fine->matrix->count;
        if (n <= COARSEST)
            break;
        int* group = new_array(int, n);
        const int groups = aggregate(fine->matrix, group);
        if (groups < n) {
            make_transfer(fine->matrix, group, levels->count == 1 ? inverse_mass : NULL,
                          &fine->transfer);
            turn_over(&fine->transfer, n, groups);
            make_coarse(fine, groups, &coarse->own);
            open_level(coarse, &coarse->own);
            levels->count++;
        }
        free(group);
        if (groups == n)
            break;
    }
    const int side = 3 * levels->level[levels->count - 1].matrix->count;
    levels->factor = new_array(double, side* side);
    levels->scratch = new_array(double, side);
}

/// The inverse of a symmetric block by its cofactors; zero where it has none.
/// Cholesky's factor of the coarsest matrix; a direction in which it is not positive is left out.
static void factorize(const BlockMatrix* matrix, double* factor) {
    const int side = 3 * matrix->count;
    memset(factor, 0, (size_t)side * (size_t)side * sizeof *factor);
    for (int i = 0; i < matrix->count; i++)
        for (int k = matrix->from[i]; k < matrix->from[i + 1]; k++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    factor[(3 * i + r) * side + 3 * matrix->column[k] + c] =
                        (double)matrix->value[k].column[c][r];
    for (int j = 0; j < side; j++) {
        double* row = &factor[j * side];
        const double whole = row[j];
        for (int c = 0; c <= j; c++) {
            const double* other = &factor[c * side];
            double sum = row[c];
            for (int k = 0; k < c; k++)
                sum -= row[k] * other[k];
            if (c < j)
                row[c] = other[c] > 0 ? sum / other[c] : 0;
            else
                row[c] = sum > (double)REAL_EPSILON * whole ? sqrt(sum) : 0;
        }
    }
}

static void solve_coarsest(const Multilevel* levels, const real4* b, real4* x) {
    const double* factor = levels->factor;
    const int side = 3 * levels->level[levels->count - 1].matrix->count;
    double* y = levels->scratch;
    for (int i = 0; i < side; i++) {
        double sum = (double)b[i / 3][i % 3];
        for (int k = 0; k < i; k++)
            sum -= factor[i * side + k] * y[k];
        y[i] = factor[i * side + i] > 0 ? sum / factor[i * side + i] : 0;
    }
    for (int i = side - 1; i >= 0; i--) {
        double sum = y[i];
        for (int k = i + 1; k < side; k++)
            sum -= factor[k * side + i] * y[k];
        y[i] = factor[i * side + i] > 0 ? sum / factor[i * side + i] : 0;
        x[i / 3][i % 3] = (real)y[i];
    }
}

void multilevel_ready(Multilevel* levels, bool all) {
    for (int l = 0; l < levels->count; l++) {
        Level* level = &levels->level[l];
        if (l > 0 && !all)
            return;
        if (l > 0)
            follow(level - 1, &level->own);
        block_kernels()->copy(level->matrix, damped, &level->slices);
    }
    factorize(levels->level[levels->count - 1].matrix, levels->factor);
}

/// coarse b = P^T left
static void restrict_to(const Level* fine, Level* coarse) {
    const Transfer* transfer = &fine->transfer;
    for (int g = 0; g < coarse->matrix->count; g++) {
        real4 sum = {0, 0, 0, 0};
        for (int k = transfer->back_from[g]; k < transfer->back_from[g + 1]; k++)
            sum += transfer->back_weight[k] * fine->left[transfer->fine[k]];
        coarse->b[g] = sum;
    }
}

/// x += P coarse x
static void prolong(const Level* fine, const Level* coarse, real4* x) {
    const Transfer* transfer = &fine->transfer;
    for (int i = 0; i < fine->matrix->count; i++)
        for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
            x[i] += transfer->weight[a] * coarse->x[transfer->coarse[a]];
}

/// x += w D^-1 (b - A x)
static void smooth(const Level* level, const real4* b, real4* x) {
    block_kernels()->relax(&level->slices, b, x, level->left);
    memcpy(x, level->left, (size_t)level->matrix->count * sizeof *x);
}

/// Bring x nearer to A^-1 b, from where it is or from zero.
static void cycle(Multilevel* levels, int l, const real4* b, real4* x, bool from_zero) {
    Level* level = &levels->level[l];
    if (l == levels->count - 1) {
        solve_coarsest(levels, b, x);
        return;
    }
    if (from_zero)
        block_kernels()->begin(&level->slices, b, x);
    else
        smooth(level, b, x);

    block_kernels()->remain(&level->slices, b, x, level->left);
    restrict_to(level, level + 1);
    const int turns = l + 2 < levels->count ? TURNS : 1; // what is solved needs no second one
    for (int turn = 0; turn < turns; turn++)
        cycle(levels, l + 1, level[1].b, level[1].x, turn == 0);
    prolong(level, level + 1, x);
    smooth(level, b, x);
}

void multilevel_apply(Multilevel* levels, const real4* b, real4* out) {
    cycle(levels, 0, b, out, true);
}

void multilevel_multiply(const Multilevel* levels, const real4* d, real4* out) {
    block_kernels()->multiply(&levels->level[0].slices, d, out);
}

void multilevel_close(Multilevel* levels) {
    for (int l = 0; l < levels->count; l++) {
        Level* level = &levels->level[l];
        block_slices_free(&level->slices);
        free(level->x);
        free(level->b);
        free(level->left);
        free(level->transfer.from);
        free(level->transfer.coarse);
        free(level->transfer.weight);
        free(level->transfer.back_from);
        free(level->transfer.fine);
        free(level->transfer.back_weight);
        free(level->slot);
        block_matrix_free(&level->own);
    }
    free(levels->factor);
    free(levels->scratch);
    *levels = (Multilevel){0};
}
