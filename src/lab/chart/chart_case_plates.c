/// Cases of the standard balloon with twice its gas between frictionless plates, and of two such
/// balloons that press each other: by symmetry the plane between them is a plate. Truths are those of
/// an axisymmetric membrane solver, confirmed by two others. Only methods that contacts leave stable play:
/// what explodes between plates has contacts without end.
#include "lab/chart/chart_sphere.h"

/// The balloon between plates a distance 2 `half_gap` apart.
typedef struct Pressed {
    double half_gap; ///< [m]
    double pressure; ///< gauge [Pa]
    double force;    ///< on a plate [N]
} Pressed;

static const Pressed pressed[] = {{0.115, 1214.015, 2.710}, {0.090, 1365.883, 16.838}};

static const double floor_height = -0.115; ///< [m] of the scene

/// The truth of the half gap that is nearest.
static const Pressed* pressed_at(double half_gap) {
    return fabs(half_gap - pressed[0].half_gap) < fabs(half_gap - pressed[1].half_gap)
               ? &pressed[0]
               : &pressed[1];
}

/// Height of the upper plate.
static double wall_height(double half_gap) {
    return floor_height + 2 * half_gap;
}

static double plates_pressure(const ChartSkin* skin, double half_gap) {
    (void)skin;
    return pressed_at(half_gap)->pressure;
}

static double plates_force(const ChartSkin* skin, double half_gap) {
    (void)skin;
    return pressed_at(half_gap)->force;
}

static double last_floor_force(const Report* report, double at) {
    (void)at;
    return report_at(report, "floor.force", -1);
}

// clang-format off
static const ChartResolution plates_euler[] = {
    {"icosphere:3", 2e-4, ANY, DOUBLE, CHART_QUICK},
    {"icosphere:4", 1e-4, ANY, DOUBLE, CHART_ALL},
    {0},
};

static const ChartResolution plates_newton[] = {
    {"icosphere:2", 2e-2, ANY, DOUBLE, CHART_FULL},
    {"icosphere:3", 2e-2, ANY, DOUBLE, CHART_QUICK},
    {"icosphere:4", 2e-2, ANY, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution plates_springs[] = {
    {"cube-sphere:8", 4e-4, ANY, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution plates_links[] = {
    {"icosphere:2", 1e-3,   ANY, DOUBLE, CHART_QUICK},
    {"icosphere:2", 2.5e-4, ANY, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution pair_euler[] = {
    {"icosphere:2", 4e-4, ANY, DOUBLE, CHART_QUICK},
    {"icosphere:3", 2e-4, ANY, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution pair_newton[] = {
    {"icosphere:2", 2e-3, ANY, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

/// The measure at one half gap.
#define BETWEEN(quantity, half_gap, function, last)                                                \
    {                                                                                              \
        .name = quantity "-" #half_gap, .about = quantity " at half gap " #half_gap " m",          \
        .at = half_gap, .key = "walls.0.at.1", .value = wall_height, .measured = last,             \
        .truth = function                                                                          \
    }

const ChartCase chart_plates = {
    .letter = "M",
    .scene = "sphere-plates",
    .about = "twice the gas between two plates: gauge pressure",
    .seconds = 0.5,
    .rows = 2,
    .skin = {{.only = "euler", .resolution = plates_euler},
             {.only = "newton", .resolution = plates_newton},
             {RUBBER_SPRINGS, .only = "euler", .resolution = plates_springs}},
    .measure = {BETWEEN("pressure", 0.115, plates_pressure, last_gauge_pressure),
                BETWEEN("pressure", 0.090, plates_pressure, last_gauge_pressure)},
    .peer = {FITTED_PEER, .set = {"balloons.0.inflation={law: gas, amount: 1, ambient: 0}"},
             .key = "balloons.0.inflation.unit", .value = own_gas, .resolution = plates_links},
};

const ChartCase chart_plates_force = {
    .letter = "M",
    .scene = "sphere-plates",
    .about = "the same: force on a plate",
    .seconds = 0.5,
    .rows = 2,
    .skin = {{.only = "euler", .resolution = plates_euler},
             {.only = "newton", .resolution = plates_newton},
             {RUBBER_SPRINGS, .only = "euler", .resolution = plates_springs}},
    .measure = {BETWEEN("force", 0.115, plates_force, last_floor_force),
                BETWEEN("force", 0.090, plates_force, last_floor_force)},
    .peer = {.none = "a soft contact keeps no force to read"},
};

const ChartCase chart_pair = {
    .letter = "N",
    .scene = "sphere-pair",
    .about = "two balloons pressed together: gauge pressure, and force on a plate",
    .seconds = 0.5,
    .rows = 2,
    .balloons = 2,
    .skin = {{.only = "euler", .resolution = pair_euler},
             {.only = "newton", .resolution = pair_newton}},
    .measure = {{.name = "pressure",
                 .about = "gauge pressure of each of two pressed together",
                 .at = 0.115,
                 .measured = last_gauge_pressure,
                 .truth = plates_pressure},
                {.name = "force",
                 .about = "force on each of two pressed together",
                 .at = 0.115,
                 .measured = last_floor_force,
                 .truth = plates_force}},
    .peer = {.none = "the peer is of one skin"},
};
