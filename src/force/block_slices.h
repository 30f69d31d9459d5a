/// A copy of a BlockMatrix for fast products: eight rows side by side (SELL-8, as in
/// body/slices.h), blocks without spare lanes. Forces add their blocks to the BlockMatrix, which
/// has one row after the other.
///
/// Its benefit: in float a frame of the rubber teddy takes 1.7 to 1.9 times as long if the
/// conjugate gradients use products of the BlockMatrix (measured as in
/// solve/multigrid/multigrid.h). Products are limited by memory reads: nine numbers a block in
/// slices, twelve in a BlockMatrix, which also has one row at a time.
#ifndef BALLOON_FORCE_BLOCK_SLICES_H
#define BALLOON_FORCE_BLOCK_SLICES_H

#include <stdint.h>

#include "base/vec.h"
#include "force/block_matrix.h"

/// Blocks of eight rows side by side.
typedef struct LaneBlock {
    real at[9][LANES]; ///< [3 column + row]
} LaneBlock;

typedef struct BlockSlices {
    int count;                 ///< slices
    int* from;                 ///< [count + 1] first slot of each
    uint32_t (*offset)[LANES]; ///< [slots] column, in bytes from the start of a real4 array
    int (*source)[LANES];      ///< [slots] index of the block in the matrix, or of its empty block
    LaneBlock* value;          ///< [slots]
    LaneBlock* inverse;        ///< [count] w times the inverses of the diagonal blocks
} BlockSlices;

/// Slices with the matrix's sparsity pattern, and zero blocks.
void block_slices_make(BlockSlices* slices, const BlockMatrix* matrix);

void block_slices_free(BlockSlices* slices);

/// The loops over slices, compiled once for each kind of machine (base/cpu.h). Arrays of vectors
/// have capacity up to the next multiple of eight (base/memory.h). D^-1: the inverses of the
/// diagonal blocks.
typedef struct BlockKernels {
    /// Copy the matrix's present values, and compute w D^-1.
    void (*update)(const BlockMatrix* matrix, real w, BlockSlices* slices);

    /// out = A d
    void (*multiply)(const BlockSlices* slices, const real4* d, real4* out);

    /// out = b - A x
    void (*residual)(const BlockSlices* slices, const real4* b, const real4* x, real4* out);

    /// out = w D^-1 b
    void (*smooth_first)(const BlockSlices* slices, const real4* b, real4* out);

    /// out = x + w D^-1 (b - A x). Returns b . out.
    double (*smooth)(const BlockSlices* slices, const real4* b, const real4* x, real4* out);
} BlockKernels;

extern const BlockKernels block_kernels_baseline;
#ifdef __x86_64__
extern const BlockKernels block_kernels_v3;
#endif

/// The kernels for this machine.
const BlockKernels* block_kernels(void);

#endif
