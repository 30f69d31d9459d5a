/// A sparse matrix of 3 x 3 blocks, row after row (block CSR).
///
///     out_i = sum over k in [from[i], from[i + 1])  value[k] d_column[k]
///
/// A row's first block is the diagonal one. The sparsity pattern is found once; the values change.
#ifndef BALLOON_FORCE_BLOCK_MATRIX_H
#define BALLOON_FORCE_BLOCK_MATRIX_H

#include "base/vec.h"

/// A 3 x 3 block of a matrix, as columns.
typedef struct Block {
    real4 column[3];
} Block;

typedef struct BlockMatrix {
    int count;    ///< rows
    int* from;    ///< [count + 1] index of each row's first block
    int* column;  ///< [from[count]] of each block
    Block* value; ///< [from[count] + 1] the last one is always zero, for padding
} BlockMatrix;

/// Make a zero matrix whose pattern is the diagonal and these pairs (row, column); pairs may
/// repeat.
void block_matrix_make(BlockMatrix* matrix, int count, const int (*pair)[2], int pairs);

/// Index of the block at (row, column), or less than 0 where there is none.
int block_matrix_find(const BlockMatrix* matrix, int row, int column);

/// Set all blocks to zero.
void block_matrix_clear(BlockMatrix* matrix);

/// out = matrix d
void block_matrix_multiply(const BlockMatrix* matrix, const real4* d, real4* out);

static inline Block* block_matrix_diagonal(const BlockMatrix* matrix, int row) {
    return &matrix->value[matrix->from[row]];
}

/// block d
static inline real4 block_times(const Block* block, real4 d) {
    return d[0] * block->column[0] + d[1] * block->column[1] + d[2] * block->column[2];
}

void block_matrix_free(BlockMatrix* matrix);

#endif
