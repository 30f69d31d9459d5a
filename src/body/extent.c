#include "body/extent.h"

#include "base/cpu.h"
#include "base/crew.h"

static const ExtentKernels* best_kernels(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return &extent_v3;
#endif
    return &extent_baseline;
}

enum { PARTS_MAX = 64, PART_SIZE_MIN = 4096 }; ///< [1], [vectors]

/// Arguments and results of the tasks.
typedef struct Job {
    const real4* a;
    int count, parts;
    real max;
    Extent* extent; ///< [parts], or
    bool* within;   ///< [parts]
} Job;

static int parts_for(int count) {
    const int parts = count / PART_SIZE_MIN + 1;
    return parts < PARTS_MAX ? parts : PARTS_MAX;
}

static int part_from(const Job* job, int part) {
    return (int)((long)job->count * part / job->parts);
}

static void part_extent(void* self, int part) {
    const Job* job = self;
    const int from = part_from(job, part), to = part_from(job, part + 1);
    job->extent[part] = best_kernels()->extent(&job->a[from], to - from);
}

Extent extent_of(const real4* a, int count) {
    Extent found[PARTS_MAX];
    const int parts = parts_for(count);
    crew_run(part_extent, &(Job){.a = a, .count = count, .parts = parts, .extent = found}, parts);
    Extent all = found[0];
    for (int part = 1; part < parts; part++)
        for (int k = 0; k < 3; k++) {
            all.low[k] = real_min(all.low[k], found[part].low[k]);
            all.high[k] = real_max(all.high[k], found[part].high[k]);
        }
    return all;
}

static void part_within(void* self, int part) {
    const Job* job = self;
    const int from = part_from(job, part), to = part_from(job, part + 1);
    job->within[part] = best_kernels()->within(&job->a[from], to - from, job->max);
}

bool all_within(const real4* a, int count, real max) {
    bool found[PARTS_MAX];
    const int parts = parts_for(count);
    Job job = {.a = a, .count = count, .parts = parts, .max = max, .within = found};
    crew_run(part_within, &job, parts);
    for (int part = 0; part < parts; part++)
        if (!found[part])
            return false;
    return true;
}

double extent_length(const Extent* extent) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const double max = fmax(-(double)extent->low[k], (double)extent->high[k]);
        sum += max * max;
    }
    return sqrt(sum);
}
