/// The machine's memory bandwidth and arithmetic throughput, measured by loops that do nothing
/// else.
#ifndef BALLOON_LAB_BENCH_MACHINE_LIMIT_H
#define BALLOON_LAB_BENCH_MACHINE_LIMIT_H

#include "base/vec.h"

typedef struct Limits {
    /// a[i] = b[i] + s c[i] for `count` numbers: moves 3 count numbers.
    void (*triad)(real* a, const real* b, const real* c, real s, int count);

    /// Independent multiplications and additions; returns their total number.
    double (*multiply_add)(int rounds, real* out);
} Limits;

/// The kernels for this machine (base/cpu.h).
const Limits* limits(void);

extern const Limits limits_baseline;
#ifdef __x86_64__
extern const Limits limits_v3;
#endif

#endif
