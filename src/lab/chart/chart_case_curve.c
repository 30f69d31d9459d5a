/// Pressure against stretch, l = 1.1 to 3, for springs of both laws and membranes of every
/// material. Each skin holds the amount of gas with which a neo-Hookean balloon rests at stretch l,
/// and its gauge pressure at rest is measured. The truth for a membrane is the closed form of its
/// own material at that amount; materials other than neo-Hookean are not in the front of all
/// points. Springs approximate neo-Hookean rubber and are compared with it; Hooke's are fitted to
/// it at l = 1.1.
#include "lab/chart/chart_sphere.h"

static const double fit_stretch = 1.1; ///< l at which Hooke's springs are fitted [1]

static double hooke_sheet(void) {
    const TruthBalloon rubber = truth_balloon_default();
    return rubber_sheet() * truth_springs_fitted(&rubber, fit_stretch).springs / rubber.springs;
}

/// Amount of gas with which rubber rests at stretch l, in amounts that fill the balloon
/// unstretched: l^3 (1 + p/p_atm).
static double amount_for(double l) {
    const TruthBalloon rubber = truth_balloon_default();
    return l * l * l * (1 + truth_pressure(&rubber, l) / rubber.ambient);
}

/// The law of a membrane's material; springs approximate rubber.
static const TruthLaw* law_of(const ChartSkin* skin) {
    return truth_law_find(skin->material ? skin->material : "neo-hookean");
}

/// Pressure at rest of a skin with the gas that stretches rubber to l.
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

/// A membrane of another material than the scene's, with the material's own parameter.
#define MEMBRANE(name, parameter)                                                                  \
    .set = {"balloons.0.skin={membrane: {material: " name ", " parameter                           \
            ", young: 1e6, density: 1000, thickness: 3e-4}}"},                                     \
    .material = name

/// The measure at one stretch.
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
