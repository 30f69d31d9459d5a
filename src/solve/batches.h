/// Springs eight side by side, none of which share a particle: what a round of constraints may
/// relax at once, as if it were one after the other.
///
/// Springs are taken in their order, each into the first open batch in which both its ends are
/// free; WINDOW batches are open at a time, so that a batch's springs are near each other in
/// memory.
#ifndef BALLOON_SOLVE_BATCHES_H
#define BALLOON_SOLVE_BATCHES_H

#include "base/lanes.h"
#include "body/springs.h"

typedef struct Batches {
    int count;
    int* filled;               ///< [count] springs of each, 1 … LANES; the lanes behind are idle
    int (*spring)[LANES];      ///< [count] 0 in an idle lane
    uint32_t (*end)[2][LANES]; ///< [count] particles, in bytes from the start of a real4 array
    real (*rest)[LANES];       ///< [count] [m], 1 in an idle lane
    real (*weight)[2][LANES];  ///< [count] of the ends, for this step [1/kg]
    real (*stiff)[LANES];      ///< [count] h^2 k, for this step; 0 in an idle lane [kg]
    real (*impulse)[3][LANES]; ///< [count] on the second end [kg m]
} Batches;

void batches_make(Batches* batches, const Springs* springs, int particles);

/// For a step: impulses are 0, weights and the stiffness that acts are taken.
void batches_begin(Batches* batches, const Springs* springs, const real* weight, real h2);

/// A round over all batches at places x + u (solve/xpbd.c); moves u.
void batches_relax(Batches* batches, SpringLaw law, const real4* x, real4* u);

void batches_free(Batches* batches);

#endif
