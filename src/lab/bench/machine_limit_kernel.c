/// Compiled for each instruction set: base/cpu.h.
#include "base/lanes.h"
#include "lab/bench/machine_limit.h"

static void triad(real* restrict a, const real* restrict b, const real* restrict c, real s,
                  int count) {
    for (int i = 0; i < count; i += WIDE)
        lanes_store(&a[i], lanes_load(&b[i]) + s * lanes_load(&c[i]));
}

enum { CHAINS = 8 }; ///< independent sums: enough to hide the latency of an addition

static double multiply_add(int rounds, real* out) {
    lanes a0 = {1}, a1 = {2}, a2 = {3}, a3 = {4}, a4 = {5}, a5 = {6}, a6 = {7}, a7 = {8};
    const lanes m = a0 * (real)0 + (real)0.999, b = a0 * (real)0 + (real)1e-3;
    for (int k = 0; k < rounds; k++) {
        a0 = a0 * m + b, a1 = a1 * m + b, a2 = a2 * m + b, a3 = a3 * m + b;
        a4 = a4 * m + b, a5 = a5 * m + b, a6 = a6 * m + b, a7 = a7 * m + b;
    }
    lanes_store(out, a0 + a1 + a2 + a3 + a4 + a5 + a6 + a7);
    return 2.0 * CHAINS * WIDE * rounds;
}

#ifdef KERNEL_V3
const Limits limits_v3 = {triad, multiply_add};
#else
const Limits limits_baseline = {triad, multiply_add};
#endif
