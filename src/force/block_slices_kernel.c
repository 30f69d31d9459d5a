/// Compiled for each kind of machine: base/cpu.h.
#include "force/block_slices.h"
#include "base/lanes.h"

#define ALWAYS inline __attribute__((always_inline))

static ALWAYS Lanes3 times(const LaneBlock* block, int lane, Lanes3 d) {
    return (Lanes3){d.x * lanes_load(&block->at[0][lane]) + d.y * lanes_load(&block->at[3][lane]) +
                        d.z * lanes_load(&block->at[6][lane]),
                    d.x * lanes_load(&block->at[1][lane]) + d.y * lanes_load(&block->at[4][lane]) +
                        d.z * lanes_load(&block->at[7][lane]),
                    d.x * lanes_load(&block->at[2][lane]) + d.y * lanes_load(&block->at[5][lane]) +
                        d.z * lanes_load(&block->at[8][lane])};
}

/// WIDE rows of A d, from row i on.
static ALWAYS Lanes3 rows_times(const BlockSlices* slices, int i, const real4* d) {
    const int slice = i / LANES, lane = lane_of(i);
    Lanes3 sum = {{0}, {0}, {0}};
    for (int slot = slices->from[slice]; slot < slices->from[slice + 1]; slot++)
        sum = lanes3_plus(
            sum, times(&slices->value[slot], lane, lanes3_gather(d, &slices->offset[slot][lane])));
    return sum;
}

/// WIDE rows of w D^-1 v, from row i on.
static ALWAYS Lanes3 inverse_times(const BlockSlices* slices, int i, Lanes3 v) {
    return times(&slices->inverse[i / LANES], lane_of(i), v);
}

static void multiply(const BlockSlices* slices, const real4* d, real4* restrict out) {
    for (int i = 0; i < slices->count * LANES; i += WIDE)
        lanes3_store(&out[i], rows_times(slices, i, d));
}

static void residual(const BlockSlices* slices, const real4* b, const real4* x,
                     real4* restrict out) {
    for (int i = 0; i < slices->count * LANES; i += WIDE)
        lanes3_store(&out[i], lanes3_minus(lanes3_load(&b[i]), rows_times(slices, i, x)));
}

static void smooth_first(const BlockSlices* slices, const real4* b, real4* restrict out) {
    for (int i = 0; i < slices->count * LANES; i += WIDE)
        lanes3_store(&out[i], inverse_times(slices, i, lanes3_load(&b[i])));
}

static double smooth(const BlockSlices* slices, const real4* b, const real4* x,
                     real4* restrict out) {
    double4 sum[LANES / 4] = {{0}, {0}};
    for (int i = 0; i < slices->count * LANES; i += WIDE) {
        const Lanes3 right = lanes3_load(&b[i]);
        const Lanes3 residual_rows = lanes3_minus(right, rows_times(slices, i, x));
        const Lanes3 next =
            lanes3_plus(lanes3_load(&x[i]), inverse_times(slices, i, residual_rows));
        lanes3_store(&out[i], next);
        lanes_sum_apart(sum, lane_of(i), lanes3_dot(right, next));
    }
    const double4 all = sum[0] + sum[1];
    return (all[0] + all[1]) + (all[2] + all[3]);
}

static ALWAYS void store(LaneBlock* block, int lane, int column, Lanes3 v) {
    lanes_store(&block->at[3 * column][lane], v.x);
    lanes_store(&block->at[3 * column + 1][lane], v.y);
    lanes_store(&block->at[3 * column + 2][lane], v.z);
}

/// w times the inverse, by cross products of the columns; zero where the determinant is not
/// positive.
static ALWAYS void invert(const LaneBlock* block, int lane, real w, LaneBlock* out) {
    Lanes3 column[3];
    for (int c = 0; c < 3; c++)
        column[c] =
            (Lanes3){lanes_load(&block->at[3 * c][lane]), lanes_load(&block->at[3 * c + 1][lane]),
                     lanes_load(&block->at[3 * c + 2][lane])};
    const Lanes3 row[3] = {lanes3_cross(column[1], column[2]), lanes3_cross(column[2], column[0]),
                           lanes3_cross(column[0], column[1])};
    const lanes determinant = lanes3_dot(column[0], row[0]);
    const lanes none = {0}, one = 1 + none;
    const lanes scale = lanes_select(determinant > 0, w * one / determinant, none);
    for (int r = 0; r < 3; r++) {
        lanes_store(&out->at[r][lane], scale * row[r].x);
        lanes_store(&out->at[3 + r][lane], scale * row[r].y);
        lanes_store(&out->at[6 + r][lane], scale * row[r].z);
    }
}

static ALWAYS void update_slice(const BlockMatrix* matrix, real w, int s, int lane,
                                BlockSlices* slices) {
    for (int slot = slices->from[s]; slot < slices->from[s + 1]; slot++) {
        const int* source = &slices->source[slot][lane];
        for (int c = 0; c < 3; c++) {
#define COLUMN(k) matrix->value[source[k]].column[c]
            store(&slices->value[slot], lane, c, LANES3_OF(COLUMN));
#undef COLUMN
        }
    }
    invert(&slices->value[slices->from[s]], lane, w, &slices->inverse[s]);
}

static void update(const BlockMatrix* matrix, real w, BlockSlices* slices) {
    for (int i = 0; i < slices->count * LANES; i += WIDE)
        update_slice(matrix, w, i / LANES, lane_of(i), slices);
}

#ifdef KERNEL_V3
const BlockKernels block_kernels_v3 = {update, multiply, residual, smooth_first, smooth};
#else
const BlockKernels block_kernels_baseline = {update, multiply, residual, smooth_first, smooth};
#endif
