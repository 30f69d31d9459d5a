#include "force/block_slices.h"

#include <stdlib.h>

#include "base/cpu.h"
#include "base/memory.h"

static int row_length(const BlockMatrix* matrix, int row) {
    return row < matrix->count ? matrix->from[row + 1] - matrix->from[row] : 0;
}

void block_slices_make(BlockSlices* slices, const BlockMatrix* matrix) {
    const int count = (matrix->count + LANES - 1) / LANES;
    *slices = (BlockSlices){.count = count, .from = new_array(int, count + 1)};
    for (int s = 0; s < count; s++) {
        int longest = 0;
        for (int k = 0; k < LANES; k++) {
            const int length = row_length(matrix, s * LANES + k);
            longest = length > longest ? length : longest;
        }
        slices->from[s + 1] = slices->from[s] + longest;
    }
    const int slots = slices->from[count];
    slices->offset = new_array(uint32_t[LANES], slots);
    slices->source = new_array(int[LANES], slots);
    slices->value = new_array(LaneBlock, slots);
    slices->inverse = new_array(LaneBlock, count);

    // rows shorter than the slice are padded with the matrix's empty block
    for (int s = 0; s < count; s++)
        for (int slot = slices->from[s]; slot < slices->from[s + 1]; slot++)
            for (int k = 0; k < LANES; k++) {
                const int row = s * LANES + k, at = slot - slices->from[s];
                const bool here = at < row_length(matrix, row);
                const int block = here ? matrix->from[row] + at : matrix->from[matrix->count];
                const int column = here ? matrix->column[block] : s * LANES;
                slices->source[slot][k] = block;
                slices->offset[slot][k] = (uint32_t)((size_t)column * sizeof(real4));
            }
}

void block_slices_free(BlockSlices* slices) {
    free(slices->from);
    free(slices->offset);
    free(slices->source);
    free(slices->value);
    free(slices->inverse);
    *slices = (BlockSlices){0};
}

const BlockKernels* block_kernels(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return &block_kernels_v3;
#endif
    return &block_kernels_baseline;
}
