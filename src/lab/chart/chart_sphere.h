/// Shared by the cases of the standard balloon: 0.1 m, 0.3 mm of rubber of 1 MPa and 1000 kg/m^3.
#ifndef BALLOON_LAB_CHART_CHART_SPHERE_H
#define BALLOON_LAB_CHART_CHART_SPHERE_H

#include <math.h>

#include "lab/chart/chart_case.h"
#include "lab/truth/truth.h"

/// Mass of the skin, 4 pi R0^2 h0 rho [kg].
#define SPHERE_MASS 0.037699111843077517

/// E h of the rubber [N/m].
static inline double rubber_sheet(void) {
    const TruthBalloon balloon = truth_balloon_default();
    return balloon.modulus * balloon.thickness;
}

/// Springs with rubber's law on a cube-sphere: a sheet with the equibiaxial stiffness of rubber.
#define RUBBER_SPRINGS .law = "rubber", .sheet = rubber_sheet, .mass = SPHERE_MASS

/// l = (V/V0)^(1/3), of the mesh's own V0.
static inline double stretch_at(const Report* report, double t) {
    return cbrt(report_at_time(report, "balloon0.volume", t) /
                report_at(report, "balloon0.volume", 0));
}

static inline double last_stretch(const Report* report, double at) {
    (void)at;
    return stretch_at(report, report_at(report, "t", -1));
}

static inline double last_gauge_pressure(const Report* report, double at) {
    (void)at;
    return report_at(report, "balloon0.gauge_pressure", -1);
}

/// Bullet's links are fitted to rubber at a stretch of 1.1, in the range that soft bodies are made
/// for.
static inline double fitted_stretch(void) {
    return 1.1;
}

static inline double fitted_pressure(void) {
    const TruthBalloon balloon = truth_balloon_default();
    return truth_pressure(&balloon, fitted_stretch());
}

#define FITTED_PEER .pressure = fitted_pressure, .stretch = fitted_stretch

/// Bullet's pressure is kPR/V, without air outside. In its favor, this kPR/V0 gives the true gauge
/// pressure at the true size of a balloon with twice its gas [Pa].
static inline double own_gas(void) {
    const TruthBalloon balloon = truth_balloon_default();
    const double l = truth_stretch_gas(&balloon, 2);
    return truth_pressure(&balloon, l) * l * l * l;
}

#endif
