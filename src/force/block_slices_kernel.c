/// Compiled for each kind of machine: base/cpu.h.
#include "force/block_slices.h"

#define ALWAYS inline __attribute__((always_inline))

static ALWAYS Lanes3 times(const LaneBlock* block, Lanes3 d) {
    return (Lanes3){d.x * lanes_load(block->at[0]) + d.y * lanes_load(block->at[3]) +
                        d.z * lanes_load(block->at[6]),
                    d.x * lanes_load(block->at[1]) + d.y * lanes_load(block->at[4]) +
                        d.z * lanes_load(block->at[7]),
                    d.x * lanes_load(block->at[2]) + d.y * lanes_load(block->at[5]) +
                        d.z * lanes_load(block->at[8])};
}

/// Eight rows of A d.
static ALWAYS Lanes3 rows_times(const BlockSlices* slices, int slice, const real4* d) {
    Lanes3 sum = {{0}, {0}, {0}};
    for (int slot = slices->from[slice]; slot < slices->from[slice + 1]; slot++)
        sum = lanes3_plus(sum, times(&slices->value[slot], lanes3_gather(d, slices->place[slot])));
    return sum;
}

static void multiply(const BlockSlices* slices, const real4* d, real4* restrict out) {
    for (int s = 0; s < slices->count; s++)
        lanes3_store(&out[s * LANES], rows_times(slices, s, d));
}

static void remain(const BlockSlices* slices, const real4* b, const real4* x, real4* restrict out) {
    for (int s = 0; s < slices->count; s++)
        lanes3_store(&out[s * LANES],
                     lanes3_minus(lanes3_load(&b[s * LANES]), rows_times(slices, s, x)));
}

static void begin(const BlockSlices* slices, const real4* b, real4* restrict out) {
    for (int s = 0; s < slices->count; s++)
        lanes3_store(&out[s * LANES], times(&slices->inverse[s], lanes3_load(&b[s * LANES])));
}

static double relax(const BlockSlices* slices, const real4* b, const real4* x,
                    real4* restrict out) {
    double4 low = {0}, high = {0};
    for (int s = 0; s < slices->count; s++) {
        const Lanes3 right = lanes3_load(&b[s * LANES]);
        const Lanes3 left = lanes3_minus(right, rows_times(slices, s, x));
        const Lanes3 next =
            lanes3_plus(lanes3_load(&x[s * LANES]), times(&slices->inverse[s], left));
        lanes3_store(&out[s * LANES], next);
        const lanes along = lanes3_dot(right, next);
        low += to_double4(lanes_low(along));
        high += to_double4(lanes_high(along));
    }
    const double4 all = low + high;
    return (all[0] + all[1]) + (all[2] + all[3]);
}

static ALWAYS void store(LaneBlock* block, int column, Lanes3 v) {
    lanes_store(block->at[3 * column], v.x);
    lanes_store(block->at[3 * column + 1], v.y);
    lanes_store(block->at[3 * column + 2], v.z);
}

/// The inverse times factor, by cross products of the columns; zero where it is not positive.
static ALWAYS void invert(const LaneBlock* block, real factor, LaneBlock* out) {
    Lanes3 column[3];
    for (int c = 0; c < 3; c++)
        column[c] = (Lanes3){lanes_load(block->at[3 * c]), lanes_load(block->at[3 * c + 1]),
                             lanes_load(block->at[3 * c + 2])};
    const Lanes3 row[3] = {lanes3_cross(column[1], column[2]), lanes3_cross(column[2], column[0]),
                           lanes3_cross(column[0], column[1])};
    const lanes determinant = lanes3_dot(column[0], row[0]);
    const lanes one = {1, 1, 1, 1, 1, 1, 1, 1}, none = {0};
    const lanes share = lanes_select(determinant > 0, factor * one / determinant, none);
    for (int r = 0; r < 3; r++) {
        lanes_store(out->at[r], share * row[r].x);
        lanes_store(out->at[3 + r], share * row[r].y);
        lanes_store(out->at[6 + r], share * row[r].z);
    }
}

static void copy(const BlockMatrix* matrix, real factor, BlockSlices* slices) {
    for (int s = 0; s < slices->count; s++) {
        for (int slot = slices->from[s]; slot < slices->from[s + 1]; slot++) {
            const int* source = slices->source[slot];
            for (int c = 0; c < 3; c++) {
#define COLUMN(k) matrix->value[source[k]].column[c]
                store(&slices->value[slot], c,
                      lanes3_of(COLUMN(0), COLUMN(1), COLUMN(2), COLUMN(3), COLUMN(4), COLUMN(5),
                                COLUMN(6), COLUMN(7)));
#undef COLUMN
            }
        }
        invert(&slices->value[slices->from[s]], factor, &slices->inverse[s]);
    }
}

#ifdef KERNEL_V3
const BlockKernels block_kernels_v3 = {copy, multiply, remain, begin, relax};
#else
const BlockKernels block_kernels_baseline = {copy, multiply, remain, begin, relax};
#endif
