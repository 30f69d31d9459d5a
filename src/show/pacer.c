#include "show/pacer.h"

#include <math.h>

// Tolerance for rounding of decimal fractions: 25 steps of 0.002 s must fit into 3/60 s. [steps],
// plus 1e-3 of it relative to the number of steps.
static const double ROUNDING = 1e-9;

long pacer_steps(double time, double step) {
    return (long)fmin(floor(time / step * (1 + 1e-3 * ROUNDING) + ROUNDING), PACER_STEPS_MAX);
}

Pacer pacer_make(double step, double frame_max) {
    return (Pacer){.step = step, .frame_max = frame_max, .slowdown = 1};
}

long pacer_due(Pacer* pacer, double elapsed) {
    const long single = pacer->single;
    pacer->single = 0;
    if (pacer->paused)
        return single;

    // counted from the start, so that rounding does not accumulate over frames
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
