#include "force/sweep.h"

#include "force/kernel.h"

/// Slices whose sums are added up first: a part of the work that depends on nothing but the skin,
/// so that the sums have one order.
enum { PART = 64 };

static int part_end(const Slices* slices, int from) {
    return from + PART < slices->count ? from + PART : slices->count;
}

SweepSums sweep(const Body* body, unsigned wanted) {
    const Slices* slices = &body->slices;
    SweepSums sums = {0};
    for (int from = 0; wanted && from < slices->count; from += PART) {
        const SweepSums part =
            kernels()->sweep(slices, from, part_end(slices, from), body->x, wanted,
                             body->springs.law, body->f, body->inflation.gradient);
        sums.area += part.area;
        sums.volume += part.volume;
    }
    return sums;
}

SweepSteep sweep_steep(const Body* body) {
    const Slices* slices = &body->slices;
    SweepSteep steep = {0};
    for (int from = 0; from < slices->count; from += PART) {
        const SweepSteep part = kernels()->steep(slices, from, part_end(slices, from), body->x,
                                                 body->inflation.gradient, body->inverse_mass);
        steep.second = fmax(steep.second, part.second);
        steep.area2 += part.area2;
        steep.volume2 += part.volume2;
    }
    return steep;
}
