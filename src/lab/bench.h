/// What is measured rather than tested: a table of cases, `balloon bench CASE`.
#ifndef BALLOON_LAB_BENCH_H
#define BALLOON_LAB_BENCH_H

#include "base/fault.h"

typedef struct BenchOptions {
    bool quick;       ///< a thinned measurement
    bool keep;        ///< keep the figures, for later runs to be compared with
    const char* only; ///< what a row's name must have in it, or NULL
    const char* out;  ///< folder for a CSV
} BenchOptions;

typedef struct BenchCase {
    const char* name;
    const char* about;

    /// Measure and print the table. False where it could not be done, or where what must not happen
    /// did.
    bool (*run)(const BenchOptions* options, Fault* fault);
} BenchCase;

extern const BenchCase bench_advise;
extern const BenchCase bench_contacts;
extern const BenchCase bench_contact_cost;
extern const BenchCase bench_contact_hour;
extern const BenchCase bench_table1;
extern const BenchCase bench_speed;
extern const BenchCase bench_thickness;

extern const BenchCase* const bench_table[];
extern const int bench_count;

/// Row by name, or NULL.
const BenchCase* bench_find(const char* name);

#endif
