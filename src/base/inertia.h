/// The inertia tensor of a few points, and its inverse.
#ifndef BALLOON_BASE_INERTIA_H
#define BALLOON_BASE_INERTIA_H

#include <stdbool.h>

#include "base/vec.h"

typedef struct Inertia {
    double4 column[3]; ///< [kg m^2]
} Inertia;

/// Add a mass at r from the centre of all.
void inertia_add(Inertia* inertia, double mass, double4 r);

/// False where the points are on one line: about that nothing turns them.
bool inertia_invert(const Inertia* inertia, Inertia* inverse);

static inline double4 inertia_times(const Inertia* inertia, double4 a) {
    return a[0] * inertia->column[0] + a[1] * inertia->column[1] + a[2] * inertia->column[2];
}

#endif
