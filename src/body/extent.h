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

/// No vector is longer.
double extent_length(const Extent* extent);

/// Whether all components are between -most and most; what is not a number is not.
bool all_within(const real4* a, int count, real most);

/// The loops on the plainest machine and on this one (base/cpu.h).
typedef struct ExtentKernels {
    Extent (*extent)(const real4* a, int count);
    bool (*within)(const real4* a, int count, real most);
} ExtentKernels;

extern const ExtentKernels extent_baseline;
#ifdef __x86_64__
extern const ExtentKernels extent_v3;
#endif

#endif
