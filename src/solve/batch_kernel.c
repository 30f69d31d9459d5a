/// Compiled for each kind of machine: base/cpu.h. Equations: xpbd.c.
#include "solve/batch_kernel.h"

#define ALWAYS inline __attribute__((always_inline))

/// Constraints now: the direction in which their length grows, their pull over the stiffness,
/// and how that grows. One of no length pulls nowhere: its direction is zero.
typedef struct Stretched {
    Lanes3 n;
    lanes pull, slope; ///< C C' [m], C'^2 [1]
    lanes now;         ///< length [m], greater than 0
} Stretched;

static ALWAYS Stretched stretched(Lanes3 d, lanes rest, SpringLaw law) {
    const lanes now = lanes_sqrt(lanes3_dot(d, d) + REAL_LEAST), over = now - rest;
    const lanes one = 1 + (lanes){0}, none = {0};
    Stretched s = {.n = lanes3_times(one / now, d), .pull = over, .slope = one, .now = now};
    if (law == LAW_TENSION) {
        s.pull = lanes_select(over < 0, none, s.pull);
        s.slope = lanes_select(over < 0, none, s.slope);
    }
    if (law == LAW_RUBBER) {
        const lanes l = now / rest, r2 = one / (l * l), root = (2 * l * l + 1) / 12;
        const lanes c1 = l * (1 + r2 + r2 * r2) / 6; // C' root^(1/2)
        s.pull = lanes_select(over > 0, rest * (1 - r2) * c1, s.pull);
        s.slope = lanes_select(over > 0, c1 * c1 / root, s.slope);
    }
    return s;
}

/// dP of constraints that have given P so far.
static ALWAYS Lanes3 change(const Stretched* s, lanes stiff, lanes weight, Lanes3 given) {
    const lanes along = lanes3_dot(given, s->n);
    const Lanes3 aside = lanes3_minus(given, lanes3_times(along, s->n));
    const lanes turned = lanes_higher(stiff * s->pull / s->now, (lanes){0});
    const lanes push = (along + stiff * s->pull) / (1 + stiff * s->slope * weight);
    const lanes back = 1 / (1 + turned * weight);
    return lanes3_minus((Lanes3){-push * s->n.x, -push * s->n.y, -push * s->n.z},
                        lanes3_times(back, aside));
}

static ALWAYS void scatter(real4* u, const uint32_t* place, Lanes3 v, int filled) {
    real4 out[WIDE];
    lanes3_store(out, v);
    for (int k = 0; k < WIDE && k < filled; k++)
        *(real4*)((char*)u + place[k]) = out[k];
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
        const Lanes3 given = {lanes_load(&impulse[0][lane]), lanes_load(&impulse[1][lane]),
                              lanes_load(&impulse[2][lane])};
        const Lanes3 by = change(&now, lanes_load(&batches->stiff[b][lane]), wi + wj, given);
        const Lanes3 all = lanes3_plus(given, by);
        lanes_store(&impulse[0][lane], all.x);
        lanes_store(&impulse[1][lane], all.y);
        lanes_store(&impulse[2][lane], all.z);
        scatter(u, i, lanes3_minus(ui, lanes3_times(wi, by)), batches->filled[b] - lane);
        scatter(u, j, lanes3_plus(uj, lanes3_times(wj, by)), batches->filled[b] - lane);
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
