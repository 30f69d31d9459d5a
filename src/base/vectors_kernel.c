/// Compiled for each kind of machine: base/cpu.h.
#include "base/lanes.h"
#include "base/vectors.h"

enum { VECTORS = WIDE / 4 }; ///< in a register

static double dot_of(const real4* a, const real4* b, int count) {
    double4 sum[4] = {{0}, {0}, {0}, {0}}; // side by side, so that none waits for another
    int i = 0;
    for (; i + 4 <= count; i += 4) {
        sum[0] += to_double4(a[i] * b[i]);
        sum[1] += to_double4(a[i + 1] * b[i + 1]);
        sum[2] += to_double4(a[i + 2] * b[i + 2]);
        sum[3] += to_double4(a[i + 3] * b[i + 3]);
    }
    for (; i < count; i++)
        sum[0] += to_double4(a[i] * b[i]);
    const double4 all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    return all[0] + all[1] + all[2];
}

static void add(real4* restrict a, real s, const real4* restrict b, int count) {
    int i = 0;
    for (; i + VECTORS <= count; i += VECTORS)
        lanes_store((real*)&a[i],
                    lanes_load((const real*)&a[i]) + s * lanes_load((const real*)&b[i]));
    for (; i < count; i++)
        a[i] += s * b[i];
}

static void turn(real4* restrict a, real s, const real4* restrict b, int count) {
    int i = 0;
    for (; i + VECTORS <= count; i += VECTORS)
        lanes_store((real*)&a[i],
                    lanes_load((const real*)&b[i]) + s * lanes_load((const real*)&a[i]));
    for (; i < count; i++)
        a[i] = b[i] + s * a[i];
}

#ifdef KERNEL_V3
const VectorKernels vector_kernels_v3 = {dot_of, add, turn};
#else
const VectorKernels vector_kernels_baseline = {dot_of, add, turn};
#endif
