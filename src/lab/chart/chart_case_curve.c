/// The pressure over the stretch, l = 1.1 to 3: springs with both laws, membranes of every
/// material. A closed gas of the amount that stretches rubber so far holds the size; its gauge
/// pressure at rest is what the skin's law says. A membrane's truth is its own law's closed form,
/// and other laws than rubber's stand apart from the best; that of springs is rubber's, for which
/// they stand, Hooke's fitted to it at l = 1.1.
#include "lab/chart/chart_sphere.h"

static const double fitted_at = 1.1; ///< [l]

static double hooke_sheet(void) {
    const TruthBalloon rubber = truth_balloon_default();
    return rubber_sheet() * truth_springs_fitted(&rubber, fitted_at).springs / rubber.springs;
}

/// The amount of gas that stretches rubber to l, in what fills the balloon: l^3 (1 + p/p_atm).
static double amount_for(double l) {
    const TruthBalloon rubber = truth_balloon_default();
    return l * l * l * (1 + truth_pressure(&rubber, l) / rubber.ambient);
}

/// Of a membrane; springs stand for rubber.
static const TruthLaw* law_of(const ChartSkin* skin) {
    return truth_law_find(skin->material ? skin->material : "neo-hookean");
}

/// Its pressure at rest with that gas.
static double pressure_for(const ChartSkin* skin, double l) {
    TruthBalloon balloon = truth_balloon_default();
    balloon.law = law_of(skin);
    return truth_pressure(&balloon, truth_stretch_gas(&balloon, amount_for(l)));
}

// clang-format off
static const ChartResolution rubber_curve[] = {
    {"icosphere:2", 2e-2, IMPLICIT, DOUBLE, CHART_QUICK},
    {"icosphere:3", 1e-4, EXPLICIT, DOUBLE, CHART_FULL},
    {"icosphere:4", 2e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution other_curve[] = {
    {"icosphere:3", 2e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {0},
};

static const ChartResolution spring_curve[] = {
    {"cube-sphere:8",  2e-2, IMPLICIT, DOUBLE, CHART_QUICK},
    {"cube-sphere:16", 2e-2, IMPLICIT, DOUBLE, CHART_FULL},
    {0},
};
static const ChartResolution curve_of_links[] = {
    {"icosphere:2", 1e-3, ANY, DOUBLE, CHART_QUICK},
    {"icosphere:2", 2.5e-4, ANY, DOUBLE, CHART_FULL},
    {0},
};
// clang-format on

/// A membrane of another material than the scene's, and the material's own parameter.
#define MEMBRANE(name, parameter)                                                                  \
    .set = {"balloons.0.skin={membrane: {material: " name ", " parameter                           \
            ", young: 1e6, density: 1000, thickness: 3e-4}}"},                                     \
    .material = name

/// A row of the curve.
#define CURVE(l)                                                                                   \
    {                                                                                              \
        .name = #l, .about = "pressure at l = " #l, .at = l,                                       \
        .key = "balloons.0.inflation.fill.to", .value = amount_for,                                \
        .measured = last_gauge_pressure, .truth = pressure_for                                     \
    }

const ChartCase chart_sphere_curve = {
    .letter = "J",
    .scene = "sphere-curve",
    .about = "pressure at rest over the stretch, skin by skin",
    .seconds = 0.4,
    .rows = 2.5,
    .skin =
        {{.set = {"guard=off"}, .resolution = rubber_curve},
         {MEMBRANE("mooney-rivlin", "mooney: 0.1"), .apart = true, .resolution = other_curve},
         {MEMBRANE("stvk", "poisson: 0.45"), .apart = true, .resolution = other_curve},
         {MEMBRANE("stvk-3d", "poisson: 0.45"), .apart = true, .resolution = other_curve},
         {RUBBER_SPRINGS, .resolution = spring_curve},
         {.law = "hooke", .sheet = hooke_sheet, .mass = SPHERE_MASS, .resolution = spring_curve}},
    .measure = {CURVE(1.1), CURVE(1.5), CURVE(2), CURVE(3)},
    .peer = {FITTED_PEER, .resolution = curve_of_links},
};
