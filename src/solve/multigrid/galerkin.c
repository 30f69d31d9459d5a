#include "solve/multigrid/galerkin.h"

#include <stdlib.h>

#include "base/memory.h"

/// Share of its block's trace that is added to the diagonal of each rotation. A rotation without
/// strain, such as that of a straight row of particles about its own line, would make the matrix
/// singular. [1]
static const real rotation_floor = (real)1e-3;

/// (row, column) in the coarser matrix of each contribution. Returns their number; with pair NULL,
/// only counts.
static int collect(const Transfer* transfer, const BlockMatrix* matrix, int (*pair)[2]) {
    const int rows = transfer->rows, aggregate_rows = transfer->aggregate_rows;
    int count = 0;
    for (int row = 0; row < matrix->count; row++)
        for (int k = matrix->from[row]; k < matrix->from[row + 1]; k++) {
            const int column = matrix->column[k], i = row / rows, j = column / rows;
            if (column < row)
                continue;
            for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
                for (int b = transfer->from[j]; b < transfer->from[j + 1]; b++)
                    for (int r = row % rows; r < aggregate_rows; r++)
                        for (int c = column % rows; c < aggregate_rows; c++, count++)
                            if (pair) {
                                pair[count][0] = transfer->term_aggregate[a] * aggregate_rows + r;
                                pair[count][1] = transfer->term_aggregate[b] * aggregate_rows + c;
                            }
        }
    return count;
}

void galerkin_make(Galerkin* galerkin, const Transfer* transfer, const BlockMatrix* matrix,
                   BlockMatrix* coarse) {
    const int contributions = collect(transfer, matrix, NULL);
    int(*pair)[2] = new_array(int[2], 2 * contributions);
    collect(transfer, matrix, pair);
    for (int p = 0; p < contributions; p++) { // and the transposed ones
        pair[contributions + p][0] = pair[p][1];
        pair[contributions + p][1] = pair[p][0];
    }
    block_matrix_make(coarse, transfer->aggregates * transfer->aggregate_rows,
                      (const int(*)[2])pair, 2 * contributions);
    galerkin->target = new_array(int, contributions);
    for (int p = 0; p < contributions; p++)
        galerkin->target[p] = block_matrix_find(coarse, pair[p][0], pair[p][1]);
    free(pair);
    galerkin->mirror = new_array(int, coarse->from[coarse->count]);
    for (int row = 0; row < coarse->count; row++)
        for (int k = coarse->from[row]; k < coarse->from[row + 1]; k++)
            galerkin->mirror[k] = block_matrix_find(coarse, coarse->column[k], row);
}

/// A E, with E d = d x m
static Block times_lever(const Block* block, real4 m) {
    const real4* a = block->column;
    return (Block){
        {m[1] * a[2] - m[2] * a[1], m[2] * a[0] - m[0] * a[2], m[0] * a[1] - m[1] * a[0]}};
}

static void add(Block* to, real weight, const Block* block) {
    for (int c = 0; c < 3; c++)
        to->column[c] += weight * block->column[c];
}

/// to += E^T A
static void add_torque(Block* to, real4 m, const Block* block) {
    for (int c = 0; c < 3; c++)
        to->column[c] += cross(m, block->column[c]);
}

/// Add the contributions of A_ij where no aggregate rotates. Returns the next target.
static const int* add_translations(const Transfer* transfer, const Block* block, int i, int j,
                                   const int* target, Block* value) {
    for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
        for (int b = transfer->from[j]; b < transfer->from[j + 1]; b++)
            add(&value[*target++], transfer->weight[a] * transfer->weight[b], block);
    return target;
}

/// Add the contributions of A_ij where aggregates rotate; A_ij couples the nodes' row r0 and column
/// c0: 0 translation, 1 rotation. Returns the next target.
static const int* add_rotations(const Transfer* transfer, const Block* block, int i, int j, int r0,
                                int c0, const int* target, Block* value) {
    for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
        for (int b = transfer->from[j]; b < transfer->from[j + 1]; b++) {
            Block by[2] = {0};
            add(&by[c0], transfer->weight[b], block);
            if (c0 == 0)
                by[1] = times_lever(block, transfer->arm[b]);
            for (int r = r0; r < 2; r++)
                for (int c = c0; c < 2; c++, target++)
                    if (r == r0)
                        add(&value[*target], transfer->weight[a], &by[c]);
                    else
                        add_torque(&value[*target], transfer->arm[a], &by[c]);
        }
    return target;
}

/// value = value + value^T
static void mirror(const int* across, int blocks, Block* value) {
    for (int k = 0; k < blocks; k++) {
        if (across[k] < k)
            continue;
        Block *here = &value[k], *there = &value[across[k]];
        const Block one = *here, other = *there;
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                there->column[r][c] = here->column[c][r] = one.column[c][r] + other.column[r][c];
    }
}

static void add_rotation_floor(BlockMatrix* coarse) {
    for (int row = 1; row < coarse->count; row += 2) {
        Block* own = block_matrix_diagonal(coarse, row);
        const real added =
            rotation_floor * (own->column[0][0] + own->column[1][1] + own->column[2][2]);
        for (int c = 0; c < 3; c++)
            own->column[c][c] += added;
    }
}

void galerkin_update(const Galerkin* galerkin, const Transfer* transfer, const BlockMatrix* matrix,
                     BlockMatrix* coarse) {
    const int rows = transfer->rows;
    const int* target = galerkin->target;
    block_matrix_clear(coarse);
    for (int row = 0; row < matrix->count; row++)
        for (int k = matrix->from[row]; k < matrix->from[row + 1]; k++) {
            const int column = matrix->column[k], i = row / rows, j = column / rows;
            if (column < row)
                continue;
            Block block = matrix->value[k];
            for (int c = 0; c < 3 && column == row; c++) // it is added again, transposed
                block.column[c] /= 2;
            target = transfer->arm
                         ? add_rotations(transfer, &block, i, j, row % rows, column % rows, target,
                                         coarse->value)
                         : add_translations(transfer, &block, i, j, target, coarse->value);
        }
    mirror(galerkin->mirror, coarse->from[coarse->count], coarse->value);
    if (transfer->arm)
        add_rotation_floor(coarse);
}

void galerkin_free(Galerkin* galerkin) {
    free(galerkin->target);
    free(galerkin->mirror);
    *galerkin = (Galerkin){0};
}
