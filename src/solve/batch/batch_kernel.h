/// An iteration over batches of springs, compiled once for each kind of machine (base/cpu.h).
#ifndef BALLOON_SOLVE_BATCH_BATCH_KERNEL_H
#define BALLOON_SOLVE_BATCH_BATCH_KERNEL_H

#include "solve/batch/batches.h"

typedef void BatchRelax(Batches* batches, SpringLaw law, const real4* x, real4* u);

BatchRelax batch_relax_baseline;
#ifdef __x86_64__
BatchRelax batch_relax_v3;
#endif

#endif
