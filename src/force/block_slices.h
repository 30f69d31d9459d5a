/// A sparse matrix of 3 x 3 blocks for products: eight rows side by side (SELL-8, as
/// body/slices.h), without spare lanes. What it holds is a copy of a BlockMatrix, which is the form
/// to add blocks to.
///
/// On 11,000 rows of rubber a product in floats takes half the time of one by BlockMatrix: nine
/// numbers of a block are read, not twelve, and reading is what takes the time.
#ifndef BALLOON_FORCE_BLOCK_SLICES_H
#define BALLOON_FORCE_BLOCK_SLICES_H

#include "base/lanes.h"
#include "force/block_matrix.h"

/// Blocks of eight rows side by side.
typedef struct LaneBlock {
    real at[9][LANES]; ///< [3 column + row]
} LaneBlock;

typedef struct BlockSlices {
    int count;                ///< slices
    int* from;                ///< [count + 1] first slot of each
    uint32_t (*place)[LANES]; ///< [slots] column, in bytes from the start of a real4 array
    int (*source)[LANES];     ///< [slots] the block in the matrix, or its empty one
    LaneBlock* value;         ///< [slots]
    LaneBlock* inverse;       ///< [count] of the diagonal blocks, times what the caller gives
} BlockSlices;

/// Slices of a matrix, all zero.
void block_slices_make(BlockSlices* slices, const BlockMatrix* matrix);

void block_slices_free(BlockSlices* slices);

/// The loops over slices, in as many compilations as there are kinds of machine (base/cpu.h).
/// Arrays of vectors have room up to the next multiple of eight (base/memory.h).
typedef struct BlockKernels {
    /// Take the matrix's present values, and the inverses of its diagonal blocks, times factor.
    void (*copy)(const BlockMatrix* matrix, real factor, BlockSlices* slices);

    /// out = A d
    void (*multiply)(const BlockSlices* slices, const real4* d, real4* out);

    /// out = b - A x
    void (*remain)(const BlockSlices* slices, const real4* b, const real4* x, real4* out);

    /// out = inverse b
    void (*begin)(const BlockSlices* slices, const real4* b, real4* out);

    /// out = x + inverse (b - A x). Returns b . out.
    double (*relax)(const BlockSlices* slices, const real4* b, const real4* x, real4* out);
} BlockKernels;

extern const BlockKernels block_kernels_baseline;
#ifdef __x86_64__
extern const BlockKernels block_kernels_v3;
#endif

/// Those of this machine.
const BlockKernels* block_kernels(void);

#endif
