/// The sphere at rest under a gas or a pressure, and the frequency of its breathing.
#include "lab/truth/truth.h"

#include <math.h>

#include "base/fault.h"
#include "lab/truth/root.h"

/// A balloon and the parameter of its equilibrium.
typedef struct Rest {
    const TruthBalloon* balloon;
    double load; ///< amount of gas [1] or pressure [Pa]
} Rest;

/// Gauge pressure of the gas minus the skin's p(l).
static double gas_excess(const void* self, double l) {
    const Rest* rest = self;
    return rest->balloon->ambient * (rest->load / (l * l * l) - 1) -
           truth_pressure(rest->balloon, l);
}

double truth_stretch_gas(const TruthBalloon* balloon, double amount) {
    ASSERT(amount >= 1, "below the amount that fills it the skin wrinkles");
    // p(l) is 0 at l = 1; the gauge pressure is 0 at V = amount V0
    const Rest rest = {balloon, amount};
    return root_between(gas_excess, &rest, 1, cbrt(amount));
}

static double pressure_excess(const void* self, double l) {
    const Rest* rest = self;
    return rest->load - truth_pressure(rest->balloon, l);
}

double truth_stretch_pressure(const TruthBalloon* balloon, double pressure) {
    ASSERT(pressure >= 0, "below zero gauge pressure the skin wrinkles");
    const Rest rest = {balloon, pressure};
    double high, most;
    // a law without a maximum reaches any pressure at some stretch
    if (!truth_peak(balloon, &high, &most))
        for (high = 10; truth_pressure(balloon, high) < pressure;)
            high *= 2;
    if (truth_pressure(balloon, high) < pressure)
        return INFINITY;
    return root_between(pressure_excess, &rest, 1, high);
}

double truth_breath_pressure(const TruthBalloon* b, double l) {
    // the derivative by l of the motion's right-hand side p R0 l^2/h0 - W', over -rho R0^2
    const double w2 = b->law->tangent(b, l) / (b->density * b->radius * b->radius) -
                      2 * l * truth_pressure(b, l) / (b->density * b->thickness * b->radius);
    return w2 >= 0 ? sqrt(w2) : NAN;
}
