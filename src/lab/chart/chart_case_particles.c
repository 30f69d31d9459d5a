/// Cases of springs and particles, sheets, strings and balls.
#include <math.h>

#include "lab/chart/chart_case.h"
#include "lab/truth/truth.h"

static const double cube_end = 0.02; ///< [s] one and a quarter periods of 0.0168 s

/// Displacement of a corner, from the volume (2 r/sqrt 3)^3.
static double cube_growth(const Report* report, double at) {
    (void)at;
    const double side = cbrt(report_at_time(report, "balloon0.volume", cube_end));
    return sqrt(3) / 2 * side - sqrt(3);
}

static double cube_pressure(void) {
    const TruthCube cube = truth_cube_default();
    const double side = 2 / sqrt(3) * truth_cube_rest(&cube);
    return 100 * cube.amount / (6 * side * side);
}

static double cube_stretch(void) {
    const TruthCube cube = truth_cube_default();
    return truth_cube_rest(&cube) / sqrt(3);
}

static double cube_truth(const ChartSkin* skin, double at) {
    (void)skin, (void)at;
    const TruthCube cube = truth_cube_default();
    return truth_cube_growth(&cube, cube_end);
}

// clang-format off
static const ChartResolution cube_resolution[] = {
    {"cube", 2e-3,    ANY, DOUBLE, CHART_QUICK},
    {"cube", 5e-4,    ANY, DOUBLE, CHART_QUICK},
    {"cube", 1.25e-4, ANY, DOUBLE, CHART_QUICK},
    {"cube", 6.25e-5, ANY, BOTH,   CHART_QUICK},
    {"cube", 1e-5,    ANY, BOTH,   CHART_FULL},
    {"cube", 1e-6,    ANY, BOTH,   CHART_FULL},
    {0},
};
// clang-format on

static const ChartResolution cube_links[] = {
    {"cube", 2e-3, ANY, DOUBLE, CHART_FULL},
    {"cube", 5e-4, ANY, BOTH, CHART_QUICK},
    {"cube", 1.25e-4, ANY, DOUBLE, CHART_FULL},
    {0},
};

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
    .peer = {.pressure = cube_pressure, .stretch = cube_stretch, .resolution = cube_links},
};

// --- two discs sewn together -------------------------------------------------------------------

static const double disc = 0.2; ///< [m]

#define FOIL_MASS 0.025132741228718346 ///< both sides, 2 pi a^2 h rho [kg]
#define FOIL "balloons.0.skin={springs: {structural: 30000, shear: 10000, law: tension}}"

static double last_volume(const Report* report, double at) {
    (void)at;
    return report_at(report, "balloon0.volume", -1);
}

static double last_height(const Report* report, double at) {
    (void)at;
    return report_at(report, "balloon0.height", -1);
}

static double mylar_volume(const ChartSkin* skin, double at) {
    (void)skin, (void)at;
    return truth_mylar(disc).volume;
}

static double mylar_thickness(const ChartSkin* skin, double at) {
    (void)skin, (void)at;
    return truth_mylar(disc).thickness;
}

// clang-format off
static const ChartResolution sewn[] = {
    {"discs:6x18",  1e-2, IMPLICIT, DOUBLE, CHART_QUICK},
    {"discs:6x18",  5e-5, EXPLICIT, DOUBLE, CHART_FULL},
    {"discs:12x36", 1e-2, IMPLICIT, DOUBLE, CHART_QUICK},
    {"discs:24x36", 1e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"discs:24x72", 1e-2, IMPLICIT, DOUBLE, CHART_ALL},
    {0},
};

static const ChartResolution sewn_links[] = {
    {"discs:12x36", 4e-3, ANY, DOUBLE, CHART_FULL},
    {"discs:12x36", 1e-3, ANY, DOUBLE, CHART_QUICK},
    {0},
};

static const ChartResolution sewn_springs[] = {
    {"discs:6x18",  1e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"discs:12x36", 1e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution sewn_foil[] = {
    {"discs:6x18",  1e-2, IMPLICIT, DOUBLE, CHART_QUICK},
    {"discs:12x36", 1e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution foil_in_small_steps[] = {
    {"discs:12x36", 1e-4, ANY, DOUBLE, CHART_QUICK},
    {0},
};
// clang-format on

const ChartCase chart_discs = {
    .letter = "E",
    .scene = "sewn-discs",
    .about = "two discs sewn together: what cannot wrinkle holds less",
    .seconds = 0.4,
    .rows = 2.5,
    .skin = {{.set = {"guard=off"}, .resolution = sewn},
             {.set = {"balloons.0.skin={springs: {structural: 1000, shear: 330}}"},
              .mass = FOIL_MASS,
              .resolution = sewn_springs},
             {.set = {FOIL}, .mass = FOIL_MASS, .resolution = sewn_foil},
             {.set = {FOIL}, .mass = FOIL_MASS, .only = "xpbd", .resolution = foil_in_small_steps}},
    .measure =
        {{.name = "volume", .about = "volume", .measured = last_volume, .truth = mylar_volume},
         {.name = "thickness",
          .about = "thickness",
          .measured = last_height,
          .truth = mylar_thickness}},
    .peer = {.resolution = sewn_links},
};

// --- a ball at rest ----------------------------------------------------------------------------

static double ball_height(const Report* report, double at) {
    (void)at;
    return report_at(report, "sphere0.y", -1);
}

// clang-format off
static const ChartResolution under_ball[] = {
    {"grid:20x20", 4e-3, ANY, DOUBLE, CHART_FULL},
    {"grid:40x40", 2e-3, STABLE_UNDAMPED, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_ball_rests = {
    .letter = "F",
    .scene = "ball-rests",
    .about = "a ball comes to rest in a sheet",
    .seconds = 4,
    .rows = 0.25,
    .skin = {{.set = {"guard=off"}, .mass = 1.681, .resolution = under_ball}},
    .measure = {{.about = "height of the ball", .measured = ball_height}},
    .peer = {.spring = 50, .resolution = under_ball},
    .reference = {"grid:40x40", {"euler", "newton"}, {1e-3, 2e-3}},
};

// --- a string ----------------------------------------------------------------------------------

static double tension(const Report* report, double at) {
    (void)at;
    return report_at(report, "balloon0.string0.tension", -1);
}

/// 386 particles of 1 g, helium's 20 + 5 m/s^2 against 9.8.
static double tether_truth(const ChartSkin* skin, double at) {
    (void)skin, (void)at;
    return truth_tether(386, 1e-3, 25, 9.8);
}

// clang-format off
static const ChartResolution tied[] = {
    {"cube-sphere:8", 2e-3,   EXPLICIT, BOTH,   CHART_QUICK},
    {"cube-sphere:8", 2e-3,   IMPLICIT, DOUBLE, CHART_FULL},
    {"cube-sphere:8", 1e-3,   ANY,      DOUBLE, CHART_FULL},
    {"cube-sphere:8", 1.0/60, EXPLICIT, DOUBLE, CHART_FULL},
    {"cube-sphere:8", 1.0/60, IMPLICIT, DOUBLE, CHART_QUICK},
    {"cube-sphere:8", 5e-2,   IMPLICIT, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

const ChartCase chart_tether = {
    .letter = "G",
    .scene = "tether",
    .about = "a balloon with helium on a string",
    .seconds = 3,
    .rows = 1 / 3.0,
    .skin = {{.set = {"guard=off"}, .resolution = tied}},
    .measure = {{.about = "tension of the string", .measured = tension, .truth = tether_truth}},
    .peer = {.none = "none: a link has no force to read"},
};

// --- the squirrel ------------------------------------------------------------------------------

static const double turning = 4; ///< [s] in the middle of its rotation
static const double anchor = -4; ///< [m] height of the string's anchor

static double squirrel_height(const Report* report, double at) {
    (void)at;
    return report_at_time(report, "balloon0.cy", turning) - anchor;
}

// clang-format off
static const ChartResolution turns[] = {
    {"squirrel.obj", 8e-3, ANY,      DOUBLE, CHART_FULL},
    {"squirrel.obj", 2e-3, EXPLICIT, BOTH,   CHART_FULL},
    {"squirrel.obj", 2e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {"squirrel.obj", 1e-3, EXPLICIT, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

static const ChartResolution turned_links[] = {
    {"squirrel.obj", 8e-3, ANY, DOUBLE, CHART_FULL},
    {"squirrel.obj", 2e-3, ANY, DOUBLE, CHART_FULL},
    {"squirrel.obj", 5e-4, ANY, DOUBLE, CHART_FULL},
    {0},
};

const ChartCase chart_squirrel_turns = {
    .letter = "H",
    .scene = "squirrel-turns",
    .about = "tied by its tail, the squirrel turns upside down",
    .seconds = 4,
    .rows = 0.25,
    .skin = {{.set = {"guard=off"}, .resolution = turns}},
    .measure = {{.about = "height above the knot after 4 s", .measured = squirrel_height}},
    .peer = {.spring = 50, .resolution = turned_links},
    .reference = {"squirrel.obj", {"euler", "newton"}, {5e-4, 8e-3}},
};
