#include "show/pacer.h"

#include <math.h>

// Times are sums of decimal fractions: 25 steps of 0.002 must fit into three 60ths of a second.
static const double ROUNDING = 1e-9; // [steps], and a thousandth of it of their number

long pacer_steps(double time, double step) {
    return (long)floor(time / step * (1 + 1e-3 * ROUNDING) + ROUNDING);
}

Pacer pacer_make(double step, double frame_max) {
    return (Pacer){.step = step, .frame_max = frame_max, .slowdown = 1};
}

long pacer_due(Pacer* pacer, double elapsed) {
    const long single = pacer->single;
    pacer->single = 0;
    if (pacer->paused)
        return single;

    // counted from one start, so that rounding does not add up over frames
    pacer->world_time += fmin(fmax(elapsed, 0), pacer->frame_max) / pacer->slowdown;
    const long due = pacer_steps(pacer->world_time, pacer->step) - pacer->steps_due;
    pacer->steps_due += due;
    return due + single;
}

void pacer_slower(Pacer* pacer) {
    if (pacer->slowdown < PACER_SLOWEST)
        pacer->slowdown *= 2;
}

void pacer_faster(Pacer* pacer) {
    if (pacer->slowdown > 1)
        pacer->slowdown /= 2;
}
