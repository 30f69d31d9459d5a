/// Compiled for each kind of machine: base/cpu.h. Equations: xpbd.c.
#include "solve/batch/batch_kernel.h"
#include "base/lanes.h"

#define ALWAYS inline __attribute__((always_inline))

/// Geometry of springs at present positions.
typedef struct Stretched {
    Lanes3 n;          ///< direction in which the length grows; zero where the length is zero
    lanes pull, slope; ///< C C' [m], C'^2 [1]
    lanes length_now;  ///< [m], greater than 0
} Stretched;

static ALWAYS Stretched stretched(Lanes3 d, lanes rest, SpringLaw law) {
    const lanes length_now = lanes_sqrt(lanes3_dot(d, d) + REAL_MIN_POSITIVE);
    const lanes over = length_now - rest;
    const lanes one = 1 + (lanes){0}, none = {0};
    Stretched s = {.n = lanes3_times(one / length_now, d),
                   .pull = over,
                   .slope = one,
                   .length_now = length_now};
    if (law == LAW_TENSION) {
        s.pull = lanes_select(over < 0, none, s.pull);
        s.slope = lanes_select(over < 0, none, s.slope);
    }
    if (law == LAW_RUBBER) {
        const lanes l = length_now / rest, r2 = one / (l * l), root = (2 * l * l + 1) / 12;
        const lanes c1 = l * (1 + r2 + r2 * r2) / 6; // C' root^(1/2)
        s.pull = lanes_select(over > 0, rest * (1 - r2) * c1, s.pull);
        s.slope = lanes_select(over > 0, c1 * c1 / root, s.slope);
    }
    return s;
}

/// dP of springs with the impulses P so far; `stiff` = h^2 k.
static ALWAYS Lanes3 impulse_change(const Stretched* s, lanes stiff, lanes weight, Lanes3 impulse) {
    const lanes along = lanes3_dot(impulse, s->n);
    const Lanes3 across = lanes3_minus(impulse, lanes3_times(along, s->n));
    const lanes stiff_across = lanes_max(stiff * s->pull / s->length_now, (lanes){0});
    const lanes change_along = (along + stiff * s->pull) / (1 + stiff * s->slope * weight);
    const lanes factor_across = 1 / (1 + stiff_across * weight);
    return lanes3_minus(
        (Lanes3){-change_along * s->n.x, -change_along * s->n.y, -change_along * s->n.z},
        lanes3_times(factor_across, across));
}

static ALWAYS void scatter(real4* u, const uint32_t* offset, Lanes3 v, int filled) {
    real4 out[WIDE];
    lanes3_store(out, v);
    for (int k = 0; k < WIDE && k < filled; k++)
        *(real4*)((char*)u + offset[k]) = out[k];
}

static ALWAYS void relax(Batches* batches, SpringLaw law, const real4* restrict x,
                         real4* restrict u) {
    for (int n = 0; n < batches->count * LANES; n += WIDE) {
        const int b = n / LANES, lane = lane_of(n);
        const uint32_t *i = &batches->end[b][0][lane], *j = &batches->end[b][1][lane];
        const lanes wi = lanes_load(&batches->weight[b][0][lane]);
        const lanes wj = lanes_load(&batches->weight[b][1][lane]);
        real(*impulse)[LANES] = batches->impulse[b];
        const Lanes3 ui = lanes3_gather(u, i), uj = lanes3_gather(u, j);
        const Lanes3 d = lanes3_plus(lanes3_minus(lanes3_gather(x, j), lanes3_gather(x, i)),
                                     lanes3_minus(uj, ui));
        const Stretched now = stretched(d, lanes_load(&batches->rest[b][lane]), law);
        const Lanes3 before = {lanes_load(&impulse[0][lane]), lanes_load(&impulse[1][lane]),
                               lanes_load(&impulse[2][lane])};
        const Lanes3 change =
            impulse_change(&now, lanes_load(&batches->stiff[b][lane]), wi + wj, before);
        const Lanes3 after = lanes3_plus(before, change);
        lanes_store(&impulse[0][lane], after.x);
        lanes_store(&impulse[1][lane], after.y);
        lanes_store(&impulse[2][lane], after.z);
        scatter(u, i, lanes3_minus(ui, lanes3_times(wi, change)), batches->filled[b] - lane);
        scatter(u, j, lanes3_plus(uj, lanes3_times(wj, change)), batches->filled[b] - lane);
    }
}

#ifdef KERNEL_V3
void batch_relax_v3(Batches* batches, SpringLaw law, const real4* x, real4* u) {
#else
void batch_relax_baseline(Batches* batches, SpringLaw law, const real4* x, real4* u) {
#endif
    switch (law) {
        case LAW_RUBBER:
            relax(batches, LAW_RUBBER, x, u);
            return;
        case LAW_TENSION:
            relax(batches, LAW_TENSION, x, u);
            return;
        default:
            relax(batches, LAW_HOOKE, x, u);
    }
}
