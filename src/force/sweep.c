#include "force/sweep.h"

#include <string.h>

#include "base/crew.h"
#include "force/kernel.h"

/// Arguments of the tasks of a sweep.
typedef struct Job {
    const Body* body;
    unsigned flags;
} Job;

static int part_end(const Slices* slices, int part) {
    const int end = (part + 1) * PART_SLICES;
    return end < slices->count ? end : slices->count;
}

static void split_part(void* self, int part) {
    const Body* body = ((const Job*)self)->body;
    kernels()->split(body->x, part * PART_PARTICLES, part_end(&body->slices, part) * LANES,
                     body->slices.coordinate);
}

static void sweep_part(void* self, int part) {
    const Job* job = self;
    const Body* body = job->body;
    const Slices* slices = &body->slices;
    if (job->flags & SWEEP_CLEAR && !(job->flags & SWEEP_SPRINGS))
        memset(&body->f[part * PART_PARTICLES], 0,
               (size_t)(part_end(slices, part) * LANES - part * PART_PARTICLES) * sizeof(real4));
    const SweepSums sums =
        kernels()->sweep(slices, part * PART_SLICES, part_end(slices, part), body->x, job->flags,
                         body->springs.law, body->f, body->inflation.gradient);
    slices->sum[part][0] = sums.area;
    slices->sum[part][1] = sums.volume;
}

SweepSums sweep(const Body* body, unsigned flags) {
    const Slices* slices = &body->slices;
    const int parts = flags ? parts_of(slices->count, PART_SLICES) : 0;
    crew_run(split_part, &(Job){body, flags}, parts);
    crew_run(sweep_part, &(Job){body, flags}, parts);
    SweepSums sums = {0};
    for (int part = 0; part < parts; part++) {
        sums.area += slices->sum[part][0];
        sums.volume += slices->sum[part][1];
    }
    return sums;
}

static void bound_part(void* self, int part) {
    const Body* body = ((const Job*)self)->body;
    const Slices* slices = &body->slices;
    const SweepBounds bounds = kernels()->bounds(slices, part * PART_SLICES, part_end(slices, part),
                                                 body->x, body->inverse_mass);
    slices->sum[part][0] = bounds.second;
    slices->sum[part][1] = bounds.area2;
    slices->sum[part][2] = bounds.volume2;
    slices->sum[part][3] = bounds.sums.area;
    slices->sum[part][4] = bounds.sums.volume;
}

SweepBounds sweep_bounds(const Body* body) {
    const Slices* slices = &body->slices;
    const int parts = parts_of(slices->count, PART_SLICES);
    crew_run(bound_part, &(Job){.body = body}, parts);
    SweepBounds bounds = {0};
    for (int part = 0; part < parts; part++) {
        bounds.second = fmax(bounds.second, slices->sum[part][0]);
        bounds.area2 += slices->sum[part][1];
        bounds.volume2 += slices->sum[part][2];
        bounds.sums.area += slices->sum[part][3];
        bounds.sums.volume += slices->sum[part][4];
    }
    return bounds;
}
