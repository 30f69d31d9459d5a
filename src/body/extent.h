/// Between which values the vectors of an array are: enough to see that nothing is near or wrong.
#ifndef BALLOON_BODY_EXTENT_H
#define BALLOON_BODY_EXTENT_H

#include <stdbool.h>

#include "base/vec.h"

/// A box; all of space where a component is not a number.
typedef struct Extent {
    real4 low, high;
} Extent;

/// a: [count], at least one.
Extent extent_of(const real4* a, int count);

/// Whether all are between -most and most.
bool extent_within(const Extent* extent, real most);

/// No vector is longer.
double extent_length(const Extent* extent);

/// extent_of on the plainest machine and on this one (base/cpu.h).
Extent extent_baseline(const real4* a, int count);
Extent extent_v3(const real4* a, int count);

#endif
