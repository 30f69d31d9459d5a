/// Compiled for each kind of machine: base/cpu.h.
#include "solve/multigrid/transfer.h"

#define ALWAYS inline __attribute__((always_inline))

static ALWAYS void sum_slices(const Sums* sums, const real4* in, bool add, bool turns,
                              real4* restrict out) {
    for (int i = 0; i < sums->count * LANES; i += WIDE) {
        const int slice = i / LANES, lane = lane_of(i);
        Lanes3 sum = {{0}, {0}, {0}};
        if (add)
            sum = lanes3_load(&out[i]);
        for (int slot = sums->from[slice]; slot < sums->from[slice + 1]; slot++) {
            const Lanes3 from = lanes3_gather(in, &sums->place[slot][lane]);
            sum = lanes3_plus(sum, lanes3_times(lanes_load(&sums->weight[slot][lane]), from));
            if (turns) {
                const real(*arm)[LANES] = (const real(*)[LANES])sums->arm[slot];
                const Lanes3 m = {lanes_load(&arm[0][lane]), lanes_load(&arm[1][lane]),
                                  lanes_load(&arm[2][lane])};
                sum = lanes3_plus(sum, lanes3_cross(from, m));
            }
        }
        lanes3_store(&out[i], sum);
    }
}

#ifdef KERNEL_V3
#define sums_of_this_kind sums_v3
#else
#define sums_of_this_kind sums_baseline
#endif

void sums_of_this_kind(const Sums* sums, const real4* in, bool add, real4* out) {
    if (sums->arm)
        sum_slices(sums, in, add, true, out);
    else
        sum_slices(sums, in, add, false, out);
}
