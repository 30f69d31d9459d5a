/// The sphere in motion, one ordinary differential equation:
///
///     l'' = (p(t, l) R0 l^2/h0 - W'(l))/(rho R0^2) - c l'
#include "lab/truth/truth.h"

#include <math.h>

/// Applied gauge pressure at time t and stretch l [Pa].
typedef double (*Applied)(const TruthBalloon* balloon, const void* self, double t, double l);

/// Parameters of the right-hand side.
typedef struct Radial {
    const TruthBalloon* balloon;
    Applied applied;
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

/// The motion at time `to`, from the state `from` at time `since`, damped by a force -damping m v
/// (damping [1/s]). Runge-Kutta of order 4; steps are halved until the final state changes by less
/// than 1e-12 or no longer converges because of rounding, which a long or nearly unbounded motion
/// amplifies. Infinite if the motion is unbounded. `applied` must be smooth between the two times.
static TruthMotion motion(const TruthBalloon* balloon, Applied applied, const void* self,
                          double damping, TruthMotion from, double since, double to) {
    enum { FEWEST = 1 << 8, MOST = 1 << 22 };
    const Radial radial = {balloon, applied, self, damping};
    // speeds are relative to the wave speed over R0, the scale of the skin's frequencies
    const double rate = sqrt(balloon->modulus / balloon->density) / balloon->radius;
    TruthMotion before = {INFINITY, INFINITY};
    double change_before = INFINITY;
    for (int count = FEWEST; count <= MOST; count *= 2) {
        const double h = (to - since) / count;
        TruthMotion at = from;
        for (int n = 0; n < count && isfinite(at.l); n++)
            at = step(&radial, since + n * h, h, at);
        const double change = fabs(at.l - before.l) + fabs(at.speed - before.speed) / rate;
        // order 4 divides the change by 16; a change that no longer falls is rounding
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
    return motion(balloon, constant, &pressure, 0, (TruthMotion){1, 0}, 0, t);
}

/// A gas whose amount grows at a constant rate.
typedef struct Filling {
    double more;     ///< final amount minus 1 [1]
    double duration; ///< [s]
} Filling;

static double filled(const TruthBalloon* balloon, const void* self, double t, double l) {
    const Filling* filling = self;
    const double amount = 1 + filling->more * fmin(1, t / filling->duration);
    return balloon->ambient * (amount / (l * l * l) - 1);
}

TruthMotion truth_filling(const TruthBalloon* balloon, double more, double duration, double damping,
                          double t) {
    // the applied pressure has a kink at the end of the filling, so integration restarts there
    const Filling filling = {more, duration};
    const double kink = fmin(t, duration);
    const TruthMotion rest = {1, 0};
    const TruthMotion at = motion(balloon, filled, &filling, damping, rest, 0, kink);
    return motion(balloon, filled, &filling, damping, at, kink, t);
}
