/// Compiled for each kind of machine: base/cpu.h. Each operation handles as many vectors as a
/// register holds.
#include "base/lanes.h"
#include "base/vectors.h"

static inline lanes load(const real4* a) {
    return lanes_load((const real*)a);
}

static double dot_of(const real4* a, const real4* b, int count) {
    double4 sum[4] = {
        {0}, {0}, {0}, {0}}; // independent sums, so that no addition waits for the one before
    int i = 0;
    for (; i + 4 <= count; i += 4)
        for (int k = 0; k < 4; k += VECTORS)
            lanes_sum_apart(sum, 4 * k, load(&a[i + k]) * load(&b[i + k]));
    for (; i < count; i++)
        sum[0] += to_double4(a[i] * b[i]);
    const double4 all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    return all[0] + all[1] + all[2];
}

static double weighted_squares(const real* w, const real4* a, int count) {
    double4 sum[2] = {{0}, {0}};
    int i = 0;
    for (; i + 2 <= count; i += 2)
        for (int k = 0; k < 2; k += VECTORS) {
            const lanes v = load(&a[i + k]);
            lanes_sum_apart(sum, 4 * k, lanes_each(&w[i + k]) * (v * v));
        }
    for (; i < count; i++)
        sum[0] += to_double4(w[i] * (a[i] * a[i]));
    const double4 all = sum[0] + sum[1];
    return all[0] + all[1] + all[2];
}

static real max_squared(const real4* a, int count) {
    lanes largest = {0};
    int i = 0;
    for (; i + WIDE <= count; i += WIDE) {
        const Lanes3 v = lanes3_load(&a[i]);
        largest = lanes_max(lanes3_dot(v, v), largest);
    }
    real all = 0;
    for (int k = 0; k < WIDE; k++)
        all = real_max(largest[k], all);
    for (; i < count; i++)
        all = real_max(dot(a[i], a[i]), all);
    return all;
}

static void add(real4* restrict a, real s, const real4* restrict b, int count) {
    int i = 0;
    for (; i + VECTORS <= count; i += VECTORS)
        lanes_store((real*)&a[i], load(&a[i]) + s * load(&b[i]));
    for (; i < count; i++)
        a[i] += s * b[i];
}

static void scale_add(real4* restrict a, real s, const real4* restrict b, int count) {
    int i = 0;
    for (; i + VECTORS <= count; i += VECTORS)
        lanes_store((real*)&a[i], load(&b[i]) + s * load(&a[i]));
    for (; i < count; i++)
        a[i] = b[i] + s * a[i];
}

#ifdef KERNEL_V3
const VectorKernels vector_kernels_v3 = {dot_of, weighted_squares, max_squared, add, scale_add};
#else
const VectorKernels vector_kernels_baseline = {dot_of, weighted_squares, max_squared, add,
                                               scale_add};
#endif
