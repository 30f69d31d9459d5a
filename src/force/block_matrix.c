#include "force/block_matrix.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

static int rising(const void* a, const void* b) {
    return *(const int*)a - *(const int*)b;
}

/// Sort the columns of a row, drop repetitions and the diagonal. Returns the remaining number.
static int settle_row(int row, int* column, int count) {
    int unique = 0;
    qsort(column, (size_t)count, sizeof *column, rising);
    for (int k = 0; k < count; k++)
        if (column[k] != row && (unique == 0 || column[k] != column[unique - 1]))
            column[unique++] = column[k];
    return unique;
}

void block_matrix_make(BlockMatrix* matrix, int count, const int (*pair)[2], int pairs) {
    // counting sort by row
    int *begin = new_array(int, count + 1), *at = new_array(int, count + 1);
    int* column = new_array(int, pairs);
    for (int p = 0; p < pairs; p++)
        begin[pair[p][0] + 1]++;
    for (int i = 0; i < count; i++)
        begin[i + 1] += begin[i];
    memcpy(at, begin, (size_t)count * sizeof *at);
    for (int p = 0; p < pairs; p++)
        column[at[pair[p][0]]++] = pair[p][1];

    *matrix = (BlockMatrix){.count = count, .from = new_array(int, count + 1)};
    for (int i = 0; i < count; i++) {
        at[i] = settle_row(i, &column[begin[i]], begin[i + 1] - begin[i]);
        matrix->from[i + 1] = matrix->from[i] + 1 + at[i];
    }
    matrix->column = new_array(int, matrix->from[count]);
    matrix->value = new_array(Block, matrix->from[count] + 1);
    for (int i = 0; i < count; i++) {
        int* row = &matrix->column[matrix->from[i]];
        row[0] = i;
        memcpy(row + 1, &column[begin[i]], (size_t)at[i] * sizeof *row);
    }
    free(begin);
    free(at);
    free(column);
}

int block_matrix_find(const BlockMatrix* matrix, int row, int column) {
    for (int k = matrix->from[row]; k < matrix->from[row + 1]; k++)
        if (matrix->column[k] == column)
            return k;
    return -1;
}

void block_matrix_clear(BlockMatrix* matrix) {
    memset(matrix->value, 0, (size_t)matrix->from[matrix->count] * sizeof *matrix->value);
}

void block_matrix_multiply(const BlockMatrix* matrix, const real4* restrict d,
                           real4* restrict out) {
    for (int i = 0; i < matrix->count; i++) {
        real4 sum = {0, 0, 0, 0};
        for (int k = matrix->from[i]; k < matrix->from[i + 1]; k++)
            sum += block_times(&matrix->value[k], d[matrix->column[k]]);
        out[i] = sum;
    }
}

void block_matrix_free(BlockMatrix* matrix) {
    free(matrix->from);
    free(matrix->column);
    free(matrix->value);
    *matrix = (BlockMatrix){0};
}
