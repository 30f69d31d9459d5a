#include "solve/multigrid/galerkin.h"

#include <stdlib.h>

#include "base/memory.h"

/// A turn that strains nothing, as of a row of particles about itself, is held by this share of
/// the others. [1]
static const real held = (real)1e-3;

/// (row, column) of all that goes into the coarser matrix. Returns how many there are; with pair
/// NULL, counts only.
static int collect(const Transfer* transfer, const BlockMatrix* matrix, int (*pair)[2]) {
    const int rows = transfer->rows, group_rows = transfer->group_rows;
    int count = 0;
    for (int row = 0; row < matrix->count; row++)
        for (int k = matrix->from[row]; k < matrix->from[row + 1]; k++) {
            const int column = matrix->column[k], i = row / rows, j = column / rows;
            if (column < row)
                continue;
            for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
                for (int b = transfer->from[j]; b < transfer->from[j + 1]; b++)
                    for (int r = row % rows; r < group_rows; r++)
                        for (int c = column % rows; c < group_rows; c++, count++)
                            if (pair) {
                                pair[count][0] = transfer->coarse[a] * group_rows + r;
                                pair[count][1] = transfer->coarse[b] * group_rows + c;
                            }
        }
    return count;
}

void galerkin_make(Galerkin* galerkin, const Transfer* transfer, const BlockMatrix* matrix,
                   BlockMatrix* coarse) {
    const int parts = collect(transfer, matrix, NULL);
    int(*pair)[2] = new_array(int[2], 2 * parts);
    collect(transfer, matrix, pair);
    for (int p = 0; p < parts; p++) { // and across the diagonal
        pair[parts + p][0] = pair[p][1];
        pair[parts + p][1] = pair[p][0];
    }
    block_matrix_make(coarse, transfer->groups * transfer->group_rows, (const int(*)[2])pair,
                      2 * parts);
    galerkin->slot = new_array(int, parts);
    for (int p = 0; p < parts; p++)
        galerkin->slot[p] = block_matrix_find(coarse, pair[p][0], pair[p][1]);
    free(pair);
    galerkin->mirror = new_array(int, coarse->from[coarse->count]);
    for (int row = 0; row < coarse->count; row++)
        for (int k = coarse->from[row]; k < coarse->from[row + 1]; k++)
            galerkin->mirror[k] = block_matrix_find(coarse, coarse->column[k], row);
}

/// A E
static Block turned_by(const Block* block, real4 m) {
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

/// Where nothing turns.
static const int* add_going(const Transfer* transfer, const Block* block, int i, int j,
                            const int* slot, Block* value) {
    for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
        for (int b = transfer->from[j]; b < transfer->from[j + 1]; b++)
            add(&value[*slot++], transfer->weight[a] * transfer->weight[b], block);
    return slot;
}

/// Of the rows r0 and c0 of the nodes.
static const int* add_turning(const Transfer* transfer, const Block* block, int i, int j, int r0,
                              int c0, const int* slot, Block* value) {
    for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
        for (int b = transfer->from[j]; b < transfer->from[j + 1]; b++) {
            Block by[2] = {0};
            add(&by[c0], transfer->weight[b], block);
            if (c0 == 0)
                by[1] = turned_by(block, transfer->arm[b]);
            for (int r = r0; r < 2; r++)
                for (int c = c0; c < 2; c++, slot++)
                    if (r == r0)
                        add(&value[*slot], transfer->weight[a], &by[c]);
                    else
                        add_torque(&value[*slot], transfer->arm[a], &by[c]);
        }
    return slot;
}

/// value = value + value^T
static void mirror(const int* mirrored, int blocks, Block* value) {
    for (int k = 0; k < blocks; k++) {
        if (mirrored[k] < k)
            continue;
        Block *here = &value[k], *there = &value[mirrored[k]];
        const Block one = *here, other = *there;
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                there->column[r][c] = here->column[c][r] = one.column[c][r] + other.column[r][c];
    }
}

static void hold_turns(BlockMatrix* coarse) {
    for (int row = 1; row < coarse->count; row += 2) {
        Block* own = block_matrix_diagonal(coarse, row);
        const real more = held * (own->column[0][0] + own->column[1][1] + own->column[2][2]);
        for (int c = 0; c < 3; c++)
            own->column[c][c] += more;
    }
}

void galerkin_follow(const Galerkin* galerkin, const Transfer* transfer, const BlockMatrix* matrix,
                     BlockMatrix* coarse) {
    const int rows = transfer->rows;
    const int* slot = galerkin->slot;
    block_matrix_clear(coarse);
    for (int row = 0; row < matrix->count; row++)
        for (int k = matrix->from[row]; k < matrix->from[row + 1]; k++) {
            const int column = matrix->column[k], i = row / rows, j = column / rows;
            if (column < row)
                continue;
            Block block = matrix->value[k];
            for (int c = 0; c < 3 && column == row; c++) // it is its own mirror
                block.column[c] /= 2;
            slot = transfer->arm ? add_turning(transfer, &block, i, j, row % rows, column % rows,
                                               slot, coarse->value)
                                 : add_going(transfer, &block, i, j, slot, coarse->value);
        }
    mirror(galerkin->mirror, coarse->from[coarse->count], coarse->value);
    if (transfer->arm)
        hold_turns(coarse);
}

void galerkin_free(Galerkin* galerkin) {
    free(galerkin->slot);
    free(galerkin->mirror);
    *galerkin = (Galerkin){0};
}
