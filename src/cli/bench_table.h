/// The benches of lab/ and show/, a table.
#ifndef BALLOON_CLI_BENCH_TABLE_H
#define BALLOON_CLI_BENCH_TABLE_H

#include "lab/bench/bench.h"

extern const BenchCase* const bench_table[];
extern const int bench_count;

/// Row by name, or NULL.
const BenchCase* bench_find(const char* name);

#endif
