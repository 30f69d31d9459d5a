#include "force/sweep.h"

#include <string.h>

#include "base/crew.h"
#include "force/kernel.h"

/// Arguments of the tasks of a sweep.
typedef struct Job {
    const Body* body;
    unsigned wanted;
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
    if (job->wanted & SWEEP_CLEAR && !(job->wanted & SWEEP_SPRINGS))
        memset(&body->f[part * PART_PARTICLES], 0,
               (size_t)(part_end(slices, part) * LANES - part * PART_PARTICLES) * sizeof(real4));
    const SweepSums sums =
        kernels()->sweep(slices, part * PART_SLICES, part_end(slices, part), body->x, job->wanted,
                         body->springs.law, body->f, body->inflation.gradient);
    slices->sum[part][0] = sums.area;
    slices->sum[part][1] = sums.volume;
}

SweepSums sweep(const Body* body, unsigned wanted) {
    const Slices* slices = &body->slices;
    const int parts = wanted ? parts_of(slices->count, PART_SLICES) : 0;
    crew_run(split_part, &(Job){body, wanted}, parts);
    crew_run(sweep_part, &(Job){body, wanted}, parts);
    SweepSums sums = {0};
    for (int part = 0; part < parts; part++) {
        sums.area += slices->sum[part][0];
        sums.volume += slices->sum[part][1];
    }
    return sums;
}

static void steep_part(void* self, int part) {
    const Body* body = ((const Job*)self)->body;
    const Slices* slices = &body->slices;
    const SweepSteep steep = kernels()->steep(slices, part * PART_SLICES, part_end(slices, part),
                                              body->x, body->inverse_mass);
    slices->sum[part][0] = steep.second;
    slices->sum[part][1] = steep.area2;
    slices->sum[part][2] = steep.volume2;
    slices->sum[part][3] = steep.sums.area;
    slices->sum[part][4] = steep.sums.volume;
}

SweepSteep sweep_steep(const Body* body) {
    const Slices* slices = &body->slices;
    const int parts = parts_of(slices->count, PART_SLICES);
    crew_run(steep_part, &(Job){.body = body}, parts);
    SweepSteep steep = {0};
    for (int part = 0; part < parts; part++) {
        steep.second = fmax(steep.second, slices->sum[part][0]);
        steep.area2 += slices->sum[part][1];
        steep.volume2 += slices->sum[part][2];
        steep.sums.area += slices->sum[part][3];
        steep.sums.volume += slices->sum[part][4];
    }
    return steep;
}
