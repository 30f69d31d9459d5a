/// Compiled for each kind of machine: base/cpu.h. Two vectors side by side in eight lanes.
#include "base/lanes.h"
#include "base/vectors.h"

static double dot_of(const real4* a, const real4* b, int count) {
    double4 sum[4] = {{0}, {0}, {0}, {0}}; // side by side, so that none waits for another
    int i = 0;
    for (; i + 4 <= count; i += 4) {
        const lanes p = lanes_load((const real*)&a[i]) * lanes_load((const real*)&b[i]);
        const lanes q = lanes_load((const real*)&a[i + 2]) * lanes_load((const real*)&b[i + 2]);
        sum[0] += to_double4(lanes_low(p));
        sum[1] += to_double4(lanes_high(p));
        sum[2] += to_double4(lanes_low(q));
        sum[3] += to_double4(lanes_high(q));
    }
    for (; i < count; i++)
        sum[0] += to_double4(a[i] * b[i]);
    const double4 all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    return all[0] + all[1] + all[2];
}

static double weigh(const real* w, const real4* a, int count) {
    double4 sum[2] = {{0}, {0}};
    int i = 0;
    for (; i + 2 <= count; i += 2) {
        const real4 low = {w[i], w[i], w[i], w[i]}, high = {w[i + 1], w[i + 1], w[i + 1], w[i + 1]};
        const lanes both = lanes_load((const real*)&a[i]);
        const lanes p = lanes_join(low, high) * (both * both);
        sum[0] += to_double4(lanes_low(p));
        sum[1] += to_double4(lanes_high(p));
    }
    for (; i < count; i++)
        sum[0] += to_double4(w[i] * (a[i] * a[i]));
    const double4 all = sum[0] + sum[1];
    return all[0] + all[1] + all[2];
}

static real most(const real4* a, int count) {
    lanes eight = {0};
    int i = 0;
    for (; i + LANES <= count; i += LANES) {
        const Lanes3 v = lanes3_load(&a[i]);
        eight = lanes_higher(lanes3_dot(v, v), eight);
    }
    real all = 0;
    for (int k = 0; k < LANES; k++)
        all = real_max(eight[k], all);
    for (; i < count; i++)
        all = real_max(dot(a[i], a[i]), all);
    return all;
}

static void add(real4* restrict a, real s, const real4* restrict b, int count) {
    int i = 0;
    for (; i + 2 <= count; i += 2)
        lanes_store((real*)&a[i],
                    lanes_load((const real*)&a[i]) + s * lanes_load((const real*)&b[i]));
    for (; i < count; i++)
        a[i] += s * b[i];
}

static void turn(real4* restrict a, real s, const real4* restrict b, int count) {
    int i = 0;
    for (; i + 2 <= count; i += 2)
        lanes_store((real*)&a[i],
                    lanes_load((const real*)&b[i]) + s * lanes_load((const real*)&a[i]));
    for (; i < count; i++)
        a[i] = b[i] + s * a[i];
}

#ifdef KERNEL_V3
const VectorKernels vector_kernels_v3 = {dot_of, weigh, most, add, turn};
#else
const VectorKernels vector_kernels_baseline = {dot_of, weigh, most, add, turn};
#endif
