/// The sphere in motion: one ordinary differential equation, and what its energy says without it.
///
///     l'' = (p(t, l) R0 l^2/h0 - W'(l))/(rho R0^2) - c l'
///
/// At a constant pressure from rest at l = 1 the energy rho R0^2 l'^2/2 + W - p R0 (l^3-1)/(3 h0)
/// stays zero, which gives the furthest stretch, the period and the step that runs away.
#include "lab/truth/truth.h"

#include <math.h>

#include "lab/truth/root.h"

#include "base/real.h"

/// All that the right-hand side needs.
typedef struct Radial {
    const TruthBalloon* balloon;
    TruthApplied applied;
    const void* self;
    double damping;
} Radial;

static double acceleration(const Radial* radial, double t, TruthMotion at) {
    const TruthBalloon* b = radial->balloon;
    const double push =
        radial->applied(b, radial->self, t, at.l) * b->radius * at.l * at.l / b->thickness;
    return (push - b->law->stress(b, at.l)) / (b->density * b->radius * b->radius) -
           radial->damping * at.speed;
}

/// One step of the classical Runge-Kutta method.
static TruthMotion step(const Radial* radial, double t, double h, TruthMotion at) {
    const double share[] = {0, 0.5, 0.5, 1}, weight[] = {1, 2, 2, 1};
    TruthMotion rate = {0}, sum = {0};
    for (int k = 0; k < 4; k++) {
        const double ahead = share[k] * h;
        const TruthMotion stage = {at.l + ahead * rate.l, at.speed + ahead * rate.speed};
        rate = (TruthMotion){stage.speed, acceleration(radial, t + ahead, stage)};
        sum.l += weight[k] / 6 * rate.l;
        sum.speed += weight[k] / 6 * rate.speed;
    }
    return (TruthMotion){at.l + h * sum.l, at.speed + h * sum.speed};
}

TruthMotion truth_radial(const TruthBalloon* balloon, TruthApplied applied, const void* self,
                         double damping, TruthMotion from, double since, double to) {
    enum { FEWEST = 1 << 8, MOST = 1 << 22 };
    const Radial radial = {balloon, applied, self, damping};
    // speeds are judged over E's wave speed by R0, the size of the skin's own rates
    const double rate = sqrt(balloon->modulus / balloon->density) / balloon->radius;
    TruthMotion before = {INFINITY, INFINITY};
    double change_before = INFINITY;
    for (int count = FEWEST; count <= MOST; count *= 2) {
        const double h = (to - since) / count;
        TruthMotion at = from;
        for (int n = 0; n < count && isfinite(at.l); n++)
            at = step(&radial, since + n * h, h, at);
        const double change = fabs(at.l - before.l) + fabs(at.speed - before.speed) / rate;
        // order 4 shrinks it 16-fold; what no longer shrinks is rounding
        if (change <= 1e-12 || (change < 1e-7 && change > change_before / 2))
            return at;
        before = at;
        change_before = change;
    }
    return isfinite(before.l) ? before : (TruthMotion){INFINITY, INFINITY};
}

static double constant(const TruthBalloon* balloon, const void* self, double t, double l) {
    (void)balloon, (void)t, (void)l;
    return *(const double*)self;
}

TruthMotion truth_sudden(const TruthBalloon* balloon, double pressure, double t) {
    return truth_radial(balloon, constant, &pressure, 0, (TruthMotion){1, 0}, 0, t);
}

/// The constant pressure that from rest just comes to rest again at l, 3 h0 W/(R0 (l^3-1)) [Pa].
static double turning(const TruthBalloon* b, double l) {
    const double energy = b->law->energy(b, l);
    return 3 * b->thickness * energy / (b->radius * (l * l * l - 1));
}

/// The slope of that pressure has the sign of (l^3-1) W' - 3 l^2 W.
static double turning_slope(const void* self, double l) {
    const TruthBalloon* b = self;
    return (l * l * l - 1) * b->law->stress(b, l) - 3 * l * l * b->law->energy(b, l);
}

/// Where it is largest: false where it still grows at l = 10.
static bool turning_peak(const TruthBalloon* balloon, double* l) {
    const double grain = 1e-3;
    for (double x = 1 + grain; x < 10; x += grain) {
        if (turning_slope(balloon, x + grain) < 0) {
            *l = root_between(turning_slope, balloon, x, x + grain);
            return true;
        }
    }
    return false;
}

double truth_sudden_limit(const TruthBalloon* balloon) {
    double l;
    return turning_peak(balloon, &l) ? turning(balloon, l) : INFINITY;
}

/// A balloon and the pressure let on.
typedef struct Sudden {
    const TruthBalloon* balloon;
    double pressure;
} Sudden;

static double turning_excess(const void* self, double l) {
    const Sudden* sudden = self;
    return turning(sudden->balloon, l) - sudden->pressure;
}

double truth_sudden_most(const TruthBalloon* balloon, double pressure) {
    double high;
    if (!turning_peak(balloon, &high))
        high = 10;
    if (turning(balloon, high) <= pressure)
        return INFINITY;
    const Sudden sudden = {balloon, pressure};
    return root_between(turning_excess, &sudden, 1 + 1e-9, high);
}

double truth_sudden_period(const TruthBalloon* balloon, double pressure) {
    const TruthBalloon* b = balloon;
    const double most = truth_sudden_most(b, pressure);
    if (!isfinite(most))
        return INFINITY;
    // l = middle - half cos(q) takes the speed's two zeros out of the integral: what is left is
    // smooth and periodic in q, and the midpoint rule converges faster than any power
    enum { POINTS = 200 };
    const double half = (most - 1) / 2;
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
        const double q = (i + 0.5) * PI / POINTS, l = 1 + half * (1 - cos(q));
        const double energy = (l * l * l - 1) / 3 * (pressure - turning(b, l)); // over R0/h0
        const double speed = sqrt(2 * energy / (b->density * b->thickness * b->radius));
        sum += half * sin(q) / speed;
    }
    return 2 * sum * PI / POINTS;
}

/// A gas that is let in at a constant rate.
typedef struct Filling {
    double more;     ///< amount at the end less 1 [1]
    double duration; ///< [s]
} Filling;

static double filled(const TruthBalloon* balloon, const void* self, double t, double l) {
    const Filling* filling = self;
    const double amount = 1 + filling->more * fmin(1, t / filling->duration);
    return balloon->ambient * (amount / (l * l * l) - 1);
}

TruthMotion truth_filling(const TruthBalloon* balloon, double more, double duration, double damping,
                          double t) {
    // the end of the filling is a kink, which no step may straddle
    const Filling filling = {more, duration};
    const double kink = fmin(t, duration);
    const TruthMotion rest = {1, 0};
    const TruthMotion at = truth_radial(balloon, filled, &filling, damping, rest, 0, kink);
    return truth_radial(balloon, filled, &filling, damping, at, kink, t);
}
