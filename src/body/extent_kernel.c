/// Compiled for each kind of machine: base/cpu.h.
#include "base/lanes.h"
#include "body/extent.h"

/// In two independent chains, so that no comparison waits for the one before.
static Extent extent(const real4* restrict a, int count) {
    lanes low[2], high[2];
    low[0] = low[1] = high[0] = high[1] = lanes_repeat(a[0]);
    lane_mask odd = low[0] != low[0];
    int i = 0;
    for (; i + 2 * VECTORS <= count; i += 2 * VECTORS)
        for (int k = 0; k < 2; k++) {
            const lanes here = lanes_load((const real*)&a[i + k * VECTORS]);
            low[k] = lanes_min(here, low[k]);
            high[k] = lanes_max(here, high[k]);
            odd |= here != here;
        }
    for (; i < count; i++) {
        const lanes one = lanes_repeat(a[i]);
        low[0] = lanes_min(one, low[0]);
        high[0] = lanes_max(one, high[0]);
        odd |= one != one;
    }
    low[0] = lanes_min(low[0], low[1]);
    high[0] = lanes_max(high[0], high[1]);

    const real all = (real)INFINITY;
    Extent box = {{0}, {0}};
    for (int k = 0; k < 3; k++) {
        const int last = k + WIDE - 4;
        const bool is_odd = odd[k] | odd[last];
        box.low[k] = is_odd ? -all : real_min(low[0][k], low[0][last]);
        box.high[k] = is_odd ? all : real_max(high[0][k], high[0][last]);
    }
    return box;
}

static bool within(const real4* restrict a, int count, real max) {
    const lanes limit = max + (lanes){0};
    lane_mask good = limit == limit, good2 = good; // two chains
    int i = 0;
    for (; i + 2 * VECTORS <= count; i += 2 * VECTORS) {
        const real* here = (const real*)&a[i];
        good &= lanes_abs(lanes_load(here)) <= limit;
        good2 &= lanes_abs(lanes_load(here + WIDE)) <= limit;
    }
    for (; i < count; i++)
        good &= lanes_abs(lanes_repeat(a[i])) <= limit;
    good &= good2;
    for (int k = 0; k < WIDE; k++)
        if (!good[k])
            return false;
    return true;
}

#ifdef KERNEL_V3
const ExtentKernels extent_v3 = {extent, within};
#else
const ExtentKernels extent_baseline = {extent, within};
#endif
