#include "force/sweep.h"

#include "force/kernel.h"
#include "mesh/measure.h"

/// Slices whose sums are added up first: a part of the work that depends on nothing but the skin,
/// so that the sums have one order.
enum { PART = 64 };

/// Gradient and sums of a skin that is no closed rings.
static void measure(Body* body, unsigned wanted) {
    Inflation* inflation = &body->inflation;
    const double area = measure_volume_gradient(body->mesh, body->x, inflation->gradient);
    if (wanted & SWEEP_AREA)
        inflation->area = area;
    if (wanted & SWEEP_VOLUME)
        inflation->volume = measure_volume(body->mesh, body->x);
}

void sweep(Body* body, unsigned wanted) {
    const Slices* slices = &body->slices;
    Inflation* inflation = &body->inflation;
    if (wanted & SWEEP_GRADIENT && !slices->rings) {
        measure(body, wanted);
        wanted &= SWEEP_SPRINGS;
    }
    if (!wanted)
        return;
    double area = 0, volume = 0;
    for (int from = 0; from < slices->count; from += PART) {
        const int to = from + PART < slices->count ? from + PART : slices->count;
        const SweepSums sums = kernels()->sweep(slices, from, to, body->x, wanted,
                                                body->springs.law, body->f, inflation->gradient);
        area += sums.area;
        volume += sums.volume;
    }
    if (wanted & SWEEP_AREA)
        inflation->area = area;
    if (wanted & SWEEP_VOLUME)
        inflation->volume = volume;
}
