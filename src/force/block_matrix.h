/// A sparse matrix of 3 x 3 blocks, row after row.
///
///     out_i = sum over k in [from[i], from[i + 1])  value[k] d_column[k]
///
/// A row's first block is its diagonal one. Which blocks there are is found once; their values
/// change.
#ifndef BALLOON_FORCE_BLOCK_MATRIX_H
#define BALLOON_FORCE_BLOCK_MATRIX_H

#include "base/vec.h"

/// A 3 x 3 block of a matrix, as columns.
typedef struct Block {
    real4 column[3];
} Block;

typedef struct BlockMatrix {
    int count;    ///< rows
    int* from;    ///< [count + 1] where row i's blocks begin
    int* column;  ///< [from[count]] which column each block is in
    Block* value; ///< [from[count] + 1] the last one stays empty
} BlockMatrix;

/// Make the zero matrix that has the diagonal and these (row, column), each as often as it likes.
void block_matrix_make(BlockMatrix* matrix, int count, const int (*pair)[2], int pairs);

/// Where the block of a row and a column is, or less than 0.
int block_matrix_find(const BlockMatrix* matrix, int row, int column);

/// All blocks zero.
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
