/// Compiled for each kind of machine: base/cpu.h.
#include "base/lanes.h"
#include "body/extent.h"

#ifdef KERNEL_V3
#define EXTENT extent_v3
#else
#define EXTENT extent_baseline
#endif

/// Two vectors at a time, in two chains.
Extent EXTENT(const real4* restrict a, int count) {
    const lanes last = lanes_join(a[0], a[count - 1]);
    lanes low[2] = {last, last}, high[2] = {last, last};
    lane_mask odd = last != last;
    for (int i = 0; i + 3 < count; i += 4)
        for (int k = 0; k < 2; k++) {
            const lanes two = lanes_load((const real*)&a[i + 2 * k]);
            low[k] = lanes_lower(two, low[k]);
            high[k] = lanes_higher(two, high[k]);
            odd |= two != two;
        }
    for (int i = count / 4 * 4; i < count; i++) {
        const lanes one = lanes_join(a[i], a[i]);
        low[0] = lanes_lower(one, low[0]);
        high[0] = lanes_higher(one, high[0]);
        odd |= one != one;
    }
    low[0] = lanes_lower(low[0], low[1]);
    high[0] = lanes_higher(high[0], high[1]);

    const real all = (real)INFINITY;
    Extent extent = {{0}, {0}};
    for (int k = 0; k < 3; k++) {
        const bool is_odd = odd[k] | odd[k + 4];
        extent.low[k] = is_odd ? -all : real_min(low[0][k], low[0][k + 4]);
        extent.high[k] = is_odd ? all : real_max(high[0][k], high[0][k + 4]);
    }
    return extent;
}
