#include "lab/chart_case.h"

const ChartCase* const chart_table[] = {&chart_exact_cube, &chart_sphere_gas,
                                        &chart_sphere_pressure, &chart_sphere_step};
const int chart_count = sizeof chart_table / sizeof *chart_table;
