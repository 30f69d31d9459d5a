#include "cli/bench_table.h"

#include "base/table.h"
#include "show/bench_frame.h"

const BenchCase* const bench_table[] = {
    &bench_speed,        &bench_table1, &bench_contact_cost, &bench_frame,     &bench_contacts,
    &bench_contact_hour, &bench_soak,   &bench_advise,       &bench_thickness, &bench_guard,
    &bench_heap,         &bench_scenes, &bench_encounters};
const int bench_count = sizeof bench_table / sizeof *bench_table;

const BenchCase* bench_find(const char* name) {
    return table_find(bench_table, bench_count, name);
}
