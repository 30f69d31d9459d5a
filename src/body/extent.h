/// Bounding box of an array of vectors: a cheap test for "nothing is near" and "all is finite".
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

/// Upper bound on the length of the vectors in the box.
double extent_length(const Extent* extent);

/// Whether all components are between -max and max; false if one is not a number.
bool all_within(const real4* a, int count, real max);

/// The loops, compiled once for each kind of machine (base/cpu.h).
typedef struct ExtentKernels {
    Extent (*extent)(const real4* a, int count);
    bool (*within)(const real4* a, int count, real max);
} ExtentKernels;

extern const ExtentKernels extent_baseline;
#ifdef __x86_64__
extern const ExtentKernels extent_v3;
#endif

#endif
