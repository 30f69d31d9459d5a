/// What is measured rather than tested: a row for each `balloon bench CASE` (cli/bench_table.h).
#ifndef BALLOON_LAB_BENCH_BENCH_H
#define BALLOON_LAB_BENCH_BENCH_H

#include "lab/bench/figures.h"

typedef struct BenchOptions {
    bool quick;       ///< a thinned measurement
    const char* only; ///< what a row's name must have in it, or NULL
    Figures* figures; ///< where a timed case's figures go
} BenchOptions;

typedef struct BenchCase {
    const char* name;
    const char* about;
    bool timed; ///< of what `balloon bench` without a name measures, in one table

    /// Measure and print. False where it could not be done, or where what must not happen did.
    bool (*run)(const BenchOptions* options, Fault* fault);
} BenchCase;

extern const BenchCase bench_advise;
extern const BenchCase bench_contacts;
extern const BenchCase bench_contact_cost;
extern const BenchCase bench_contact_hour;
extern const BenchCase bench_table1;
extern const BenchCase bench_speed;
extern const BenchCase bench_thickness;

#endif
