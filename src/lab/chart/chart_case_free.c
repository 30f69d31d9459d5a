/// Cases of invariance: results that must not depend on step and mesh, and motions that a free
/// balloon must not begin.
#include "base/vec.h"
#include "lab/chart/chart_sphere.h"

// --- step and mesh -----------------------------------------------------------------------------

static double rest_truth(const ChartSkin* skin, double at) {
    (void)skin, (void)at;
    const TruthBalloon balloon = truth_balloon_default();
    return truth_stretch_pressure(&balloon, 1108.503372);
}

// clang-format off
static const ChartResolution rate_and_mesh[] = {
    {"cube-sphere:13", 1.0 / 30,  STABLE_UNDAMPED, DOUBLE, CHART_QUICK},
    {"cube-sphere:13", 1.0 / 60,  STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {"cube-sphere:13", 1.0 / 120, STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {"cube-sphere:13", 1.0 / 240, STABLE_UNDAMPED, DOUBLE, CHART_QUICK},
    {"cube-sphere:13", 1.0 / 480, STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {"cube-sphere:13", 1.0 / 960, STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {"cube-sphere:9",  1.0 / 60,  STABLE_UNDAMPED, DOUBLE, CHART_QUICK},
    {"cube-sphere:18", 1.0 / 60,  IMPLICIT, DOUBLE, CHART_FULL},
    {"cube-sphere:26", 1.0 / 60,  IMPLICIT, DOUBLE, CHART_FULL},
    {"cube-sphere:43", 1.0 / 60,  IMPLICIT, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution rate_of_links[] = {
    {"cube-sphere:9", 1.0 / 30,  ANY, DOUBLE, CHART_FULL},
    {"cube-sphere:9", 1.0 / 60,  ANY, DOUBLE, CHART_QUICK},
    {"cube-sphere:9", 1.0 / 120, ANY, DOUBLE, CHART_FULL},
    {"cube-sphere:9", 1.0 / 240, ANY, DOUBLE, CHART_QUICK},
    {"cube-sphere:9", 1.0 / 480, ANY, DOUBLE, CHART_FULL},
    {"cube-sphere:9", 1.0 / 960, ANY, DOUBLE, CHART_QUICK},
    {"cube-sphere:18", 1.0 / 60, ANY, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution rate_of_springs[] = {
    {"cube-sphere:13", 1.0 / 30,  STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {"cube-sphere:13", 1.0 / 60,  STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {"cube-sphere:13", 1.0 / 240, STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {"cube-sphere:13", 1.0 / 960, STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_independence = {
    .letter = "K",
    .scene = "sphere-pressure",
    .about = "30 to 960 steps a second, 400 to 11,000 quads, guard on",
    .seconds = 0.3,
    .rows = 1 / 0.3,
    .skin = {{.set = {"guard=split"}, .resolution = rate_and_mesh},
             {.set = {"guard=split"}, RUBBER_SPRINGS, .resolution = rate_of_springs}},
    .measure = {{.name = "independence",
                 .about = "mean stretch",
                 .measured = last_stretch,
                 .truth = rest_truth}},
    .peer = {FITTED_PEER, .step = 1.0 / 240, .resolution = rate_of_links},
};

// --- undisturbed -------------------------------------------------------------------------------

static const char* const position[] = {"balloon0.cx", "balloon0.cy", "balloon0.cz"};

/// Three columns of a row.
static double4 vector_at(const Report* report, const char* const name[3], int row) {
    return (double4){report_at(report, name[0], row), report_at(report, name[1], row),
                     report_at(report, name[2], row), 0};
}

/// Largest acceleration of the center of mass between rows, from its positions in three. [m/s^2]
static double self_acceleration(const Report* report, double at) {
    (void)at;
    double max = 0;
    for (int k = 1; k + 1 < report->rows; k++) {
        const double dt = report_at(report, "t", k) - report_at(report, "t", k - 1);
        const double4 bend = vector_at(report, position, k + 1) -
                             2 * vector_at(report, position, k) +
                             vector_at(report, position, k - 1);
        max = fmax(max, dlength(bend) / (dt * dt));
    }
    return max;
}

/// Largest angular momentum about its own center over a thin shell's 2/3 m r^2 [rad/s].
static double self_spin(const Report* report, double at) {
    (void)at;
    static const char* const about_origin[] = {"balloon0.lx", "balloon0.ly", "balloon0.lz"};
    static const char* const momentum[] = {"balloon0.px", "balloon0.py", "balloon0.pz"};
    double max = 0;
    for (int k = 0; k < report->rows; k++) {
        const double radius = 0.1 * stretch_at(report, report_at(report, "t", k));
        const double4 l = vector_at(report, about_origin, k) -
                          dcross(vector_at(report, position, k), vector_at(report, momentum, k));
        max = fmax(max, dlength(l) / (2.0 / 3 * SPHERE_MASS * radius * radius));
    }
    return max;
}

static double nothing(const ChartSkin* skin, double at) {
    (void)skin, (void)at;
    return 0;
}

// clang-format off
static const ChartResolution alone[] = {
    {"icosphere:2", 4e-4, EXPLICIT, BOTH, CHART_QUICK},
    {"icosphere:2", 1e-2, IMPLICIT, BOTH, CHART_QUICK},
    {0},
};

static const ChartResolution alone_links[] = {
    {"icosphere:2", 1.0 / 60, ANY, BOTH,   CHART_QUICK},
    {"icosphere:2", 1e-3,     ANY, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution alone_springs[] = {
    {"cube-sphere:6", 5e-4, EXPLICIT, BOTH, CHART_FULL},
    {"cube-sphere:6", 1e-2, IMPLICIT, BOTH, CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_sphere_free = {
    .letter = "L",
    .scene = "sphere-free",
    .about = "a free balloon left alone for 10 s",
    .seconds = 10,
    .rows = 10,
    .skin = {{.resolution = alone}, {RUBBER_SPRINGS, .resolution = alone_springs}},
    .measure = {{.name = "acceleration",
                 .about = "acceleration that it gives itself",
                 .unit = "m/s^2",
                 .measured = self_acceleration,
                 .truth = nothing},
                {.name = "spin",
                 .about = "spin that it gives itself",
                 .unit = "rad/s",
                 .measured = self_spin,
                 .truth = nothing}},
    .peer =
        {FITTED_PEER,
         .set = {"balloons.0.inflation={law: gas, amount: 0, ambient: 0, fill: {to: 1, seconds: "
                 "0.5}}"},
         .key = "balloons.0.inflation.unit", .value = own_gas, .resolution = alone_links},
};
