#include "body/extent.h"

#include "base/cpu.h"

Extent extent_of(const real4* a, int count) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return extent_v3(a, count);
#endif
    return extent_baseline(a, count);
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
