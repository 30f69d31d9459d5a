#include "body/extent.h"

#include "base/cpu.h"
#include "base/crew.h"

static Extent of_range(const real4* a, int count) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return extent_v3(a, count);
#endif
    return extent_baseline(a, count);
}

enum { PARTS_MOST = 64, PART_LEAST = 4096 }; ///< [1], [vectors]

/// What the parts are given, and what they find.
typedef struct Job {
    const real4* a;
    int count, parts;
    Extent extent[PARTS_MOST];
} Job;

static void part_extent(void* self, int part) {
    Job* job = self;
    const int from = (int)((long)job->count * part / job->parts);
    const int to = (int)((long)job->count * (part + 1) / job->parts);
    job->extent[part] = of_range(&job->a[from], to - from);
}

Extent extent_of(const real4* a, int count) {
    const int parts = count / PART_LEAST + 1;
    Job job = {.a = a, .count = count, .parts = parts < PARTS_MOST ? parts : PARTS_MOST};
    crew_run(part_extent, &job, job.parts);
    Extent all = job.extent[0];
    for (int part = 1; part < job.parts; part++)
        for (int k = 0; k < 3; k++) {
            all.low[k] = real_min(all.low[k], job.extent[part].low[k]);
            all.high[k] = real_max(all.high[k], job.extent[part].high[k]);
        }
    return all;
}

bool extent_within(const Extent* extent, real most) {
    for (int k = 0; k < 3; k++)
        if (!(extent->low[k] >= -most && extent->high[k] <= most))
            return false;
    return true;
}

double extent_length(const Extent* extent) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const double most = fmax(-(double)extent->low[k], (double)extent->high[k]);
        sum += most * most;
    }
    return sqrt(sum);
}
