/// What this machine can do at most, measured by loops that do nothing else.
#ifndef BALLOON_LAB_BENCH_MACHINE_LIMIT_H
#define BALLOON_LAB_BENCH_MACHINE_LIMIT_H

#include "base/vec.h"

typedef struct Limits {
    /// a[i] = b[i] + s c[i] over `count` numbers, which is 3 of them moved each.
    void (*triad)(real* a, const real* b, const real* c, real s, int count);

    /// Multiplications and additions that do not wait for each other. Returns their number, in all.
    double (*multiply_add)(int rounds, real* out);
} Limits;

/// For this machine (base/cpu.h).
const Limits* limits(void);

extern const Limits limits_baseline;
#ifdef __x86_64__
extern const Limits limits_v3;
#endif

#endif
