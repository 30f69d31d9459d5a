/// Benches, measurements without a verdict: a row for each `balloon bench CASE`
/// (cli/bench_table.h).
#ifndef BALLOON_LAB_BENCH_BENCH_H
#define BALLOON_LAB_BENCH_BENCH_H

#include "lab/bench/figures.h"

typedef struct BenchOptions {
    bool quick;       ///< a thinned measurement
    const char* only; ///< measure rows with this word in their names; NULL: all
    const char* out;  ///< folder for other files
    Figures* figures; ///< receives the figures of a timed case
} BenchOptions;

typedef struct BenchCase {
    const char* name;
    const char* about;
    bool timed; ///< part of the table of `balloon bench` without a name

    /// Measure and print. Returns false with a fault if that failed or a requirement was violated.
    bool (*run)(const BenchOptions* options, Fault* fault);
} BenchCase;

extern const BenchCase bench_advise;
extern const BenchCase bench_contacts;
extern const BenchCase bench_contact_cost;
extern const BenchCase bench_contact_hour;
extern const BenchCase bench_encounters;
extern const BenchCase bench_guard;
extern const BenchCase bench_heap;
extern const BenchCase bench_scenes;
extern const BenchCase bench_table1;
extern const BenchCase bench_soak;
extern const BenchCase bench_speed;
extern const BenchCase bench_thickness;

#endif
