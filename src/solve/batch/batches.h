/// Batches of eight springs that share no particle. Relaxing them at once gives the same result as
/// relaxing them one after the other (a graph coloring of the constraints).
///
/// Each spring, in order, joins the first open batch in which neither of its ends occurs. WINDOW
/// batches are open at a time, so that a batch's springs are near each other in memory.
#ifndef BALLOON_SOLVE_BATCH_BATCHES_H
#define BALLOON_SOLVE_BATCH_BATCHES_H

#include <stdint.h>

#include "base/vec.h"
#include "body/springs.h"

typedef struct Batches {
    int count;
    int* filled;               ///< [count] springs in each, 1 … LANES; further lanes are idle
    int (*spring)[LANES];      ///< [count] 0 in an idle lane
    uint32_t (*end)[2][LANES]; ///< [count] particles, in bytes from the start of a real4 array
    real (*rest)[LANES];       ///< [count] [m], 1 in an idle lane
    real (*weight)[2][LANES];  ///< [count] of the ends, for this step [1/kg]
    real (*stiff)[LANES];      ///< [count] h^2 k, for this step; 0 in an idle lane [kg]
    real (*impulse)[3][LANES]; ///< [count] on the second end [kg m]
} Batches;

void batches_make(Batches* batches, const Springs* springs, int particles);

/// Before a step: set impulses to 0, copy weights and each spring's present stiffness.
void batches_begin(Batches* batches, const Springs* springs, const real* weight, real h2);

/// An iteration over all batches at positions x + u (solve/xpbd.c); changes u.
void batches_relax(Batches* batches, SpringLaw law, const real4* x, real4* u);

void batches_free(Batches* batches);

#endif
