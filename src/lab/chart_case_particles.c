/// Cases of springs and particles.
#include <math.h>

#include "lab/chart_case.h"
#include "lab/truth.h"

static const double cube_end = 0.02; ///< [s] one and a quarter swings of 0.0168 s

/// The corner's way out, from the volume (2 r/sqrt 3)^3.
static double cube_growth(const Report* report) {
    const double side = cbrt(report_at_time(report, "balloon0.volume", cube_end));
    return sqrt(3) / 2 * side - sqrt(3);
}

static double cube_truth(const ChartSkin* skin) {
    (void)skin;
    const TruthCube cube = truth_cube_default();
    return truth_cube_growth(&cube, cube_end);
}

// clang-format off
static const ChartResolution cube_resolution[] = {
    {"cube", 4e-3,    ANY, DOUBLE, CHART_FULL},
    {"cube", 2e-3,    ANY, DOUBLE, CHART_QUICK},
    {"cube", 1e-3,    ANY, DOUBLE, CHART_FULL},
    {"cube", 5e-4,    ANY, BOTH,   CHART_QUICK},
    {"cube", 2.5e-4,  ANY, DOUBLE, CHART_FULL},
    {"cube", 1.25e-4, ANY, BOTH,   CHART_QUICK},
    {"cube", 6.25e-5, ANY, BOTH,   CHART_QUICK},
    {"cube", 1e-5,    ANY, BOTH,   CHART_FULL},
    {"cube", 1e-6,    ANY, BOTH,   CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_exact_cube = {
    .letter = "A",
    .scene = "exact-cube",
    .about = "a cube of 8 particles, one degree of freedom, swings",
    .seconds = cube_end,
    .rows = 50,
    .skin = {{.resolution = cube_resolution}},
    .measure = {{.about = "way of a corner after 0.02 s",
                 .measured = cube_growth,
                 .truth = cube_truth}},
};
