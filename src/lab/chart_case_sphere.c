/// Cases of the standard balloon: 0.1 m, 0.3 mm of rubber of 1 MPa and 1000 kg/m^3.
///
/// Its skin is a membrane on icospheres, or springs with rubber's law on cube-spheres, fitted as a
/// sheet of equibiaxial stiffness 2 E h: kd = E h/2, ks + 4 kf = E h.
#include <math.h>

#include "lab/chart_case.h"
#include "lab/truth.h"

/// E h = 300 N/m.
#define RUBBER_SPRINGS                                                                             \
    "balloons.0.skin={springs: {structural: 200, shear: 150, flexion: 25, law: rubber}}"

/// 4 pi R0^2 h0 rho.
static const double skin_mass = 0.037699111843077517; ///< [kg]

/// l, from volumes.
static double stretch_in(const Report* report, double t) {
    return cbrt(report_at_time(report, "balloon0.volume", t) /
                report_at(report, "balloon0.volume", 0));
}

static double last_time(const Report* report) {
    return report_at(report, "t", -1);
}

// --- a closed gas ------------------------------------------------------------------------------

static double gauge_pressure(const Report* report) {
    return report_at(report, "balloon0.gauge_pressure", -1);
}

static double gas_truth(const ChartSkin* skin) {
    (void)skin;
    const TruthBalloon balloon = truth_balloon_default();
    return truth_pressure(&balloon, truth_stretch_gas(&balloon, 2));
}

// clang-format off
static const ChartResolution settled_membrane[] = {
    {"icosphere:1", 1e-3, ANY,      DOUBLE, CHART_FULL},
    {"icosphere:1", 2e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:2", 4e-4, ANY,      BOTH,   CHART_QUICK},
    {"icosphere:2", 2e-2, ANY,      BOTH,   CHART_QUICK},
    {"icosphere:3", 4e-4, EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:3", 2e-4, EXPLICIT, BOTH,   CHART_QUICK},
    {"icosphere:3", 1e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:3", 2e-2, IMPLICIT, BOTH,   CHART_QUICK},
    {"icosphere:4", 1e-4, EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 2e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:5", 5e-5, EXPLICIT, DOUBLE, CHART_ALL},
    {"icosphere:5", 2e-2, IMPLICIT, DOUBLE, CHART_ALL},
    {0},
};

static const ChartResolution settled_springs[] = {
    {"cube-sphere:4",  1e-3, ANY,      DOUBLE, CHART_FULL},
    {"cube-sphere:8",  5e-4, ANY,      BOTH,   CHART_QUICK},
    {"cube-sphere:8",  1e-2, IMPLICIT, BOTH,   CHART_FULL},
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
    .skin = {{.resolution = settled_membrane},
             {.set = {RUBBER_SPRINGS}, .mass = skin_mass, .resolution = settled_springs}},
    .measure = {{.about = "gauge pressure", .measured = gauge_pressure, .truth = gas_truth}},
};

// --- a constant pressure -----------------------------------------------------------------------

static double last_stretch(const Report* report) {
    return stretch_in(report, last_time(report));
}

static double pressure_truth(const ChartSkin* skin) {
    (void)skin;
    const TruthBalloon balloon = truth_balloon_default();
    return truth_stretch_pressure(&balloon, 1108.503372);
}

/// Where the swing is small and not yet lost in rounding. [s]
static const double swing_from = 0.1, swing_to = 0.2;

/// Solve the symmetric a x = b of three rows by Cramer's rule.
static void solve_three(double a[3][3], const double b[3], double x[3]) {
    const double d01 = a[0][0] * a[1][1] - a[0][1] * a[1][0],
                 d02 = a[0][0] * a[1][2] - a[0][2] * a[1][0],
                 d12 = a[0][1] * a[1][2] - a[0][2] * a[1][1];
    const double det = a[2][0] * d12 - a[2][1] * d02 + a[2][2] * d01;
    for (int c = 0; c < 3; c++) {
        const double(*m)[3] = (const double(*)[3])a;
        const int i = (c + 1) % 3, j = (c + 2) % 3;
        x[c] = (b[0] * (m[1][i] * m[2][j] - m[1][j] * m[2][i]) +
                b[1] * (m[2][i] * m[0][j] - m[2][j] * m[0][i]) +
                b[2] * (m[0][i] * m[1][j] - m[0][j] * m[1][i])) /
               det;
    }
}

/// A decaying swing about a constant, sampled every dt, obeys y_(k+1) = p y_k + q y_(k-1) + r:
/// least squares give p and q (Prony), whose roots z = exp(s dt) give w = |s|, whatever damps it.
static double breathing(const Report* report) {
    double a[3][3] = {{0}}, b[3] = {0}, x[3], dt = 0;
    for (int k = 1; k + 1 < report->rows; k++) {
        const double t = report_at(report, "t", k);
        if (t < swing_from || t > swing_to)
            continue;
        dt = report_at(report, "t", k + 1) - t;
        const double row[3] = {stretch_in(report, t), stretch_in(report, t - dt), 1};
        const double next = stretch_in(report, t + dt);
        const double shift = 1.2; // near the mean, so that squares do not cancel
        const double y[3] = {row[0] - shift, row[1] - shift, 1};
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++)
                a[i][j] += y[i] * y[j];
            b[i] += y[i] * (next - shift);
        }
    }
    solve_three(a, b, x);
    // z^2 - p z - q = 0: |z|^2 = -q, cos(angle) = p/(2 |z|)
    const double size = sqrt(-x[1]), decay = log(size) / dt;
    const double swing = acos(x[0] / (2 * size)) / dt;
    return sqrt(decay * decay + swing * swing);
}

static double breathing_truth(const ChartSkin* skin) {
    const TruthBalloon balloon = truth_balloon_default();
    return truth_breath_pressure(&balloon, pressure_truth(skin));
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
    .skin = {{.resolution = breathing_membrane},
             {.set = {RUBBER_SPRINGS}, .mass = skin_mass, .resolution = breathing_springs}},
    .measure = {{.name = "radius",
                 .about = "stretch at rest",
                 .measured = last_stretch,
                 .truth = pressure_truth},
                {.name = "frequency",
                 .about = "frequency of breathing",
                 .measured = breathing,
                 .truth = breathing_truth}},
};

// --- a sudden pressure -------------------------------------------------------------------------

static double first_stretch(const Report* report) {
    return stretch_in(report, 0.01);
}

static double second_stretch(const Report* report) {
    return stretch_in(report, 0.02);
}

static double sudden_truth(double t) {
    const TruthBalloon balloon = truth_balloon_default();
    return truth_sudden(&balloon, 800, t).l;
}

static double first_truth(const ChartSkin* skin) {
    (void)skin;
    return sudden_truth(0.01);
}

static double second_truth(const ChartSkin* skin) {
    (void)skin;
    return sudden_truth(0.02);
}

// clang-format off
static const ChartResolution sudden_membrane[] = {
    {"icosphere:1", 1e-3,     ANY,      DOUBLE, CHART_FULL},
    {"icosphere:2", 1e-3,     ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:2", 5e-4,     ANY,      BOTH,   CHART_QUICK},
    {"icosphere:2", 2.5e-4,   ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:2", 1.25e-4,  ANY,      DOUBLE, CHART_QUICK},
    {"icosphere:3", 5e-4,     ANY,      DOUBLE, CHART_FULL},
    {"icosphere:3", 2.5e-4,   ANY,      BOTH,   CHART_FULL},
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
    {"cube-sphere:16", 6.25e-5, EXPLICIT, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_sphere_step = {
    .letter = "D",
    .scene = "sphere-step",
    .about = "800 Pa let on at once, undamped: how far it is stretched",
    .seconds = 0.02,
    .rows = 100,
    .skin = {{.resolution = sudden_membrane},
             {.set = {RUBBER_SPRINGS}, .mass = skin_mass, .resolution = sudden_springs}},
    .measure = {{.name = "0.01s",
                 .about = "stretch after 0.01 s",
                 .measured = first_stretch,
                 .truth = first_truth},
                {.name = "0.02s",
                 .about = "stretch after 0.02 s",
                 .measured = second_stretch,
                 .truth = second_truth}},
};
