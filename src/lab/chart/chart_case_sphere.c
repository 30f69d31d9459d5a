/// Cases of the standard balloon at rest and in motion. Membranes are on icospheres, springs on
/// cube-spheres.
#include "lab/chart/chart_sphere.h"

// clang-format off
static const ChartResolution links[] = {
    {"icosphere:2", 1.0 / 60, ANY, BOTH,   CHART_QUICK},
    {"icosphere:2", 4e-3,     ANY, DOUBLE, CHART_FULL},
    {"icosphere:2", 1e-3,     ANY, BOTH,   CHART_QUICK},
    {"icosphere:2", 2.5e-4,   ANY, DOUBLE, CHART_FULL},
    {"icosphere:3", 1e-3,     ANY, DOUBLE, CHART_FULL},
    {"icosphere:3", 2.5e-4,   ANY, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution short_links[] = {
    {"icosphere:2", 1e-3,   ANY, DOUBLE, CHART_FULL},
    {"icosphere:2", 5e-4,   ANY, BOTH,   CHART_QUICK},
    {"icosphere:2", 2.5e-4, ANY, DOUBLE, CHART_FULL},
    {"icosphere:3", 2.5e-4, ANY, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

// --- a closed gas ------------------------------------------------------------------------------

static double gas_truth(const ChartSkin* skin, double at) {
    (void)skin, (void)at;
    const TruthBalloon balloon = truth_balloon_default();
    return truth_pressure(&balloon, truth_stretch_gas(&balloon, 2));
}

// clang-format off
static const ChartResolution settled_membrane[] = {
    {"icosphere:1", 1e-3, ANY,      DOUBLE, CHART_FULL},
    {"icosphere:1", 2e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:2", 4e-4, ANY,      BOTH,   CHART_QUICK},
    {"icosphere:2", 2e-2, ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:3", 4e-4, EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:3", 2e-4, EXPLICIT, BOTH,   CHART_QUICK},
    {"icosphere:3", 1e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:3", 2e-2, IMPLICIT, BOTH,   CHART_QUICK},
    {"icosphere:4", 1e-4, EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 2e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:5", 5e-5, EXPLICIT, DOUBLE, CHART_ALL},
    {"icosphere:5", 2e-2, IMPLICIT, DOUBLE, CHART_ALL},
    {"cube-sphere:9", 2e-2, IMPLICIT, DOUBLE, CHART_QUICK},
    {"cube-sphere:9", 1.0 / 240, IMPLICIT, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution settled_springs[] = {
    {"cube-sphere:4",  1e-3, ANY,      DOUBLE, CHART_FULL},
    {"cube-sphere:8",  5e-4, ANY,      DOUBLE, CHART_QUICK},
    {"cube-sphere:8",  1e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"cube-sphere:16", 2e-4, EXPLICIT, DOUBLE, CHART_FULL},
    {"cube-sphere:16", 1e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"cube-sphere:32", 1e-4, ANY,      DOUBLE, CHART_ALL},
    {0},
};
// clang-format on

const ChartCase chart_sphere_gas = {
    .letter = "B",
    .scene = "sphere-gas",
    .about = "twice the gas that fills it: gauge pressure at rest",
    .seconds = 0.2,
    .rows = 5,
    .skin = {{.resolution = settled_membrane}, {RUBBER_SPRINGS, .resolution = settled_springs}},
    .measure = {{.about = "gauge pressure", .measured = last_gauge_pressure, .truth = gas_truth}},
    .peer = {FITTED_PEER, .set = {"balloons.0.inflation={law: gas, amount: 1, ambient: 0}"},
             .key = "balloons.0.inflation.unit", .value = own_gas, .resolution = links},
};

// --- a constant pressure -----------------------------------------------------------------------

static double pressure_truth(const ChartSkin* skin, double at) {
    (void)skin, (void)at;
    const TruthBalloon balloon = truth_balloon_default();
    return truth_stretch_pressure(&balloon, 1108.503372);
}

/// The times at which the oscillation is small, and large against rounding. [s]
static const double swing_from = 0.1, swing_to = 0.2;

/// Determinant of the rows of a symmetric matrix.
static double determinant(const double* a, const double* b, const double* c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Solve m x = b for a symmetric m of three rows, by Cramer's rule; its rows are also its columns.
static void solve_three(const double m[3][3], const double b[3], double x[3]) {
    const double whole = determinant(m[0], m[1], m[2]);
    x[0] = determinant(b, m[1], m[2]) / whole;
    x[1] = determinant(m[0], b, m[2]) / whole;
    x[2] = determinant(m[0], m[1], b) / whole;
}

/// A damped oscillation about a constant, sampled every dt, satisfies y_(k+1) = p y_k + q y_(k-1) +
/// r: least squares give p and q (Prony's method); their roots z = exp(s dt) give w = |s|, the
/// undamped frequency.
static double breathing(const Report* report, double at) {
    const double mean = last_stretch(report, at); // subtracted, so that squares do not cancel
    double a[3][3] = {{0}}, b[3] = {0}, x[3], dt = 0;
    for (int k = 1; k + 1 < report->rows; k++) {
        const double t = report_at(report, "t", k);
        if (t < swing_from || t > swing_to)
            continue;
        dt = report_at(report, "t", k + 1) - t;
        const double y[3] = {stretch_at(report, t) - mean, stretch_at(report, t - dt) - mean, 1};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++)
                a[i][j] += y[i] * y[j];
            b[i] += y[i] * (stretch_at(report, t + dt) - mean);
        }
    }
    solve_three((const double(*)[3])a, b, x);
    // z^2 - p z - q = 0: |z|^2 = -q, cos(angle) = p/(2 |z|)
    const double size = sqrt(-x[1]), decay = log(size) / dt;
    const double swing = acos(x[0] / (2 * size)) / dt;
    return sqrt(decay * decay + swing * swing);
}

static double breathing_truth(const ChartSkin* skin, double at) {
    const TruthBalloon balloon = truth_balloon_default();
    return truth_breath_pressure(&balloon, pressure_truth(skin, at));
}

// clang-format off
static const ChartResolution breathing_membrane[] = {
    {"icosphere:1", 1e-3,    ANY,      DOUBLE, CHART_FULL},
    {"icosphere:2", 2e-3,    IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:2", 5e-4,    ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:3", 2.5e-4,  EXPLICIT, BOTH,   CHART_QUICK},
    {"icosphere:3", 2e-3,    IMPLICIT, DOUBLE, CHART_QUICK},
    {"icosphere:3", 5e-4,    IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 1e-4,    EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 2e-3,    IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 5e-5,    EXPLICIT, DOUBLE, CHART_ALL},
    {0},
};

static const ChartResolution breathing_springs[] = {
    {"cube-sphere:4",  1e-3,   ANY,      DOUBLE, CHART_FULL},
    {"cube-sphere:8",  5e-4,   ANY,      DOUBLE, CHART_QUICK},
    {"cube-sphere:8",  2e-3,   IMPLICIT, DOUBLE, CHART_FULL},
    {"cube-sphere:16", 2.5e-4, EXPLICIT, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_sphere_pressure = {
    .letter = "C",
    .scene = "sphere-pressure",
    .about = "1108.503372 Pa: stretch at rest, and how it breathes about it",
    .seconds = 0.3,
    .rows = 500,
    .skin = {{.resolution = breathing_membrane}, {RUBBER_SPRINGS, .resolution = breathing_springs}},
    .measure = {{.name = "radius",
                 .about = "stretch at rest",
                 .measured = last_stretch,
                 .truth = pressure_truth},
                {.name = "frequency",
                 .about = "frequency of breathing",
                 .measured = breathing,
                 .truth = breathing_truth}},
    .peer = {FITTED_PEER, .resolution = short_links},
};

// --- a sudden pressure -------------------------------------------------------------------------

static double sudden_truth(const ChartSkin* skin, double at) {
    (void)skin;
    const TruthBalloon balloon = truth_balloon_default();
    return truth_sudden(&balloon, 800, at).l;
}

// clang-format off
static const ChartResolution sudden_membrane[] = {
    {"icosphere:1", 1e-3,     ANY,      DOUBLE, CHART_FULL},
    {"icosphere:2", 1e-3,     ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:2", 5e-4,     ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:2", 2.5e-4,   ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:2", 1.25e-4,  ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:3", 2.5e-4,   ANY,      DOUBLE, CHART_FULL},
    {"icosphere:3", 6.25e-5,  ANY,      BOTH,   CHART_FULL},
    {"icosphere:4", 1.25e-4,  EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 3.125e-5, EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:5", 1.5625e-5, EXPLICIT, DOUBLE, CHART_ALL},
    {0},
};

static const ChartResolution sudden_springs[] = {
    {"cube-sphere:8",  1e-3,    ANY,      DOUBLE, CHART_FULL},
    {"cube-sphere:8",  5e-4,    ANY,      DOUBLE, CHART_QUICK},
    {"cube-sphere:16", 2.5e-4,  ANY,      DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_sphere_step = {
    .letter = "D",
    .scene = "sphere-step",
    .about = "800 Pa let on at once, undamped: how far it is stretched",
    .seconds = 0.02,
    .rows = 100,
    .skin = {{.resolution = sudden_membrane}, {RUBBER_SPRINGS, .resolution = sudden_springs}},
    .measure = {{.name = "0.01s",
                 .about = "stretch after 0.01 s",
                 .at = 0.01,
                 .measured = stretch_at,
                 .truth = sudden_truth},
                {.name = "0.02s",
                 .about = "stretch after 0.02 s",
                 .at = 0.02,
                 .measured = stretch_at,
                 .truth = sudden_truth}},
    .peer = {FITTED_PEER, .resolution = short_links},
};

// --- slow filling ------------------------------------------------------------------------------

static const double fill_more = 0.5, fill_seconds = 0.01, fill_damping = 50;

static double fill_truth(const ChartSkin* skin, double at) {
    (void)skin;
    const TruthBalloon balloon = truth_balloon_default();
    return truth_filling(&balloon, fill_more, fill_seconds, fill_damping, at).l;
}

// clang-format off
static const ChartResolution fill_membrane[] = {
    {"icosphere:1", 5e-4,     ANY,      DOUBLE, CHART_FULL},
    {"icosphere:2", 5e-4,     ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:2", 2.5e-4,   ANY,      DOUBLE, CHART_FULL},
    {"icosphere:3", 2.5e-4,   ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:3", 6.25e-5,  EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 6.25e-5,  EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 3.125e-5, EXPLICIT, DOUBLE, CHART_ALL},
    {0},
};

static const ChartResolution fill_springs[] = {
    {"cube-sphere:8",  5e-4,   ANY,      DOUBLE, CHART_QUICK},
    {"cube-sphere:16", 2.5e-4, ANY,      DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_sphere_fill = {
    .letter = "I",
    .scene = "sphere-fill",
    .about = "half as much gas again within 0.01 s",
    .seconds = 0.02,
    .rows = 100,
    .skin = {{.resolution = fill_membrane}, {RUBBER_SPRINGS, .resolution = fill_springs}},
    .measure = {{.name = "0.01s",
                 .about = "stretch after 0.01 s",
                 .at = 0.01,
                 .measured = stretch_at,
                 .truth = fill_truth},
                {.name = "0.02s",
                 .about = "stretch after 0.02 s",
                 .at = 0.02,
                 .measured = stretch_at,
                 .truth = fill_truth}},
    .peer = {FITTED_PEER, .resolution = short_links},
};
