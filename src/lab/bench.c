#include "lab/bench.h"

#include <string.h>

const BenchCase* const bench_table[] = {&bench_contacts};
const int bench_count = sizeof bench_table / sizeof *bench_table;

const BenchCase* bench_find(const char* name) {
    for (int k = 0; k < bench_count; k++)
        if (strcmp(bench_table[k]->name, name) == 0)
            return bench_table[k];
    return NULL;
}
