#include "lab/chart/chart_case.h"

const ChartCase* const chart_table[] = {
    &chart_exact_cube,   &chart_sphere_gas,     &chart_sphere_pressure,
    &chart_sphere_step,  &chart_discs,          &chart_ball_rests,
    &chart_tether,       &chart_squirrel_turns, &chart_sphere_fill,
    &chart_sphere_curve, &chart_independence,   &chart_sphere_free,
    &chart_plates,       &chart_plates_force,   &chart_pair,
};
const int chart_count = sizeof chart_table / sizeof *chart_table;
