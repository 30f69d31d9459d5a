/// The sphere at rest under a gas or a pressure, where it begins to fly, and how fast it breathes.
#include "lab/truth/truth.h"

#include <math.h>

#include "base/fault.h"
#include "lab/truth/root.h"

/// A balloon and the number that its rest depends on.
typedef struct Rest {
    const TruthBalloon* balloon;
    double given; ///< amount of gas [1] or pressure [Pa]
} Rest;

/// Gauge pressure of the gas less what the skin holds.
static double gas_excess(const void* self, double l) {
    const Rest* rest = self;
    return rest->balloon->ambient * (rest->given / (l * l * l) - 1) -
           truth_pressure(rest->balloon, l);
}

double truth_stretch_gas(const TruthBalloon* balloon, double amount) {
    ASSERT(amount >= 1, "below the amount that fills it the skin wrinkles");
    // at l = 1 the skin holds nothing; at V = amount V0 the gas presses no more
    const Rest rest = {balloon, amount};
    return root_between(gas_excess, &rest, 1, cbrt(amount));
}

static double pressure_excess(const void* self, double l) {
    const Rest* rest = self;
    return rest->given - truth_pressure(rest->balloon, l);
}

double truth_stretch_pressure(const TruthBalloon* balloon, double pressure) {
    ASSERT(pressure >= 0, "below zero gauge pressure the skin wrinkles");
    const Rest rest = {balloon, pressure};
    double high, most;
    // a law without a maximum holds any pressure at some stretch
    if (!truth_peak(balloon, &high, &most))
        for (high = 10; truth_pressure(balloon, high) < pressure;)
            high *= 2;
    if (truth_pressure(balloon, high) < pressure)
        return INFINITY;
    return root_between(pressure_excess, &rest, 1, high);
}

/// Mass of the air displaced less the helium's and the skin's, over 4 pi R0^2 [kg/m^2].
static double buoyancy(const void* self, double l) {
    const TruthBalloon* b = self;
    const double squeezed = (b->ambient + truth_pressure(b, l)) / b->ambient;
    const double volume = b->radius * l * l * l / 3;
    return b->air * volume * (1 - b->helium * squeezed) - b->thickness * b->density;
}

double truth_stretch_flight(const TruthBalloon* balloon) {
    // of a law without a maximum the helium grows too dense again: the first crossing is the answer
    const double step = 1e-3;
    for (double l = 1; l < 10; l += step)
        if (buoyancy(balloon, l + step) > 0)
            return root_between(buoyancy, balloon, l, l + step);
    return INFINITY;
}

/// w of a sphere at stretch l whose applied pressure p has (l^2 p)' = `slope` [Pa]: the motion's
/// right-hand side p R0 l^2/h0 - W' differentiated by l, over -rho R0^2.
static double breath(const TruthBalloon* b, double l, double slope) {
    const double w2 = b->law->tangent(b, l) / (b->density * b->radius * b->radius) -
                      slope / (b->density * b->thickness * b->radius);
    return w2 >= 0 ? sqrt(w2) : NAN;
}

double truth_breath_pressure(const TruthBalloon* balloon, double l) {
    return breath(balloon, l, 2 * l * truth_pressure(balloon, l));
}

double truth_breath_gas(const TruthBalloon* balloon, double amount, double exponent) {
    // l^2 p = P l0^(3 exponent) l^(2 - 3 exponent) - p_atm l^2, differentiated at l0
    const double l = truth_stretch_gas(balloon, amount);
    const double absolute = balloon->ambient * amount / (l * l * l);
    return breath(balloon, l, l * absolute * (2 - 3 * exponent) - 2 * l * balloon->ambient);
}
