/// Compiled for each kind of machine: base/cpu.h.
#include "solve/multigrid/transfer.h"
#include "base/lanes.h"

#define ALWAYS inline __attribute__((always_inline))

static ALWAYS void multiply(const TransferSlices* slices, const real4* in, bool add, bool rotates,
                            real4* restrict out) {
    for (int i = 0; i < slices->count * LANES; i += WIDE) {
        const int slice = i / LANES, lane = lane_of(i);
        Lanes3 sum = {{0}, {0}, {0}};
        if (add)
            sum = lanes3_load(&out[i]);
        for (int slot = slices->from[slice]; slot < slices->from[slice + 1]; slot++) {
            const Lanes3 from = lanes3_gather(in, &slices->offset[slot][lane]);
            sum = lanes3_plus(sum, lanes3_times(lanes_load(&slices->weight[slot][lane]), from));
            if (rotates) {
                const real(*arm)[LANES] = (const real(*)[LANES])slices->arm[slot];
                const Lanes3 m = {lanes_load(&arm[0][lane]), lanes_load(&arm[1][lane]),
                                  lanes_load(&arm[2][lane])};
                sum = lanes3_plus(sum, lanes3_cross(from, m));
            }
        }
        lanes3_store(&out[i], sum);
    }
}

#ifdef KERNEL_V3
#define transfer_multiply transfer_multiply_v3
#else
#define transfer_multiply transfer_multiply_baseline
#endif

void transfer_multiply(const TransferSlices* slices, const real4* in, bool add, real4* out) {
    if (slices->arm)
        multiply(slices, in, add, true, out);
    else
        multiply(slices, in, add, false, out);
}
