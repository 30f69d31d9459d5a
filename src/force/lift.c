/// Lift: the air outside grows denser downward and pushes up with its own weight; the gas inside
/// has weight too. With M the first moment of the volume in height (mesh/moment.h)
///
///     E = -rho g M + m g M / V        rho of the air, m of the gas
///     f = rho g dM/dx - m g (dM/dx / V - M / V^2 dV/dx)
///
/// The total is (rho V - m) g upward through the volume's centroid. The inertia of the gas is
/// neglected, and so is that of the air that moves with the skin (added mass), which is as large.
#include "force/force.h"
#include "mesh/measure.h"
#include "mesh/moment.h"

static bool present(const Body* body) {
    return body->inflation.law == INFLATE_GAS && body->inflation.weighs && body->gravity != 0;
}

/// f = of_moment dM/dx + of_volume dV/dx. Heights are measured from a level near the skin, so that
/// a skin far from the origin loses no digits.
typedef struct Lift {
    double level, volume, moment;
    double air, gas; ///< weights per volume, and of the gas in all [N/m^3], [N]
    double of_moment, of_volume;
} Lift;

static Lift lift_of(const Body* body) {
    Lift lift = {
        .level = (double)body->x[0][1],
        .volume = measure_volume(body->mesh, body->x),
        .air = air_density * body->gravity,
        .gas = gas_mass(&body->inflation) * body->gravity,
    };
    lift.moment = moment_of_height(body->mesh, body->x, lift.level);
    lift.of_moment = lift.air - lift.gas / lift.volume;
    lift.of_volume = lift.air * lift.level + lift.gas * lift.moment / (lift.volume * lift.volume);
    return lift;
}

static void add(Body* body) {
    const Lift lift = lift_of(body);
    real4* gradient = body->inflation.gradient;
    measure_volume_gradient(body->mesh, body->x, gradient);
    moment_add_gradient(body->mesh, body->x, lift.level, (real)lift.of_moment, body->f);
    for (int i = 0; i < body->count; i++)
        body->f[i] += (real)lift.of_volume * gradient[i];
}

static double energy(const Body* body) {
    const Lift lift = lift_of(body);
    return -lift.air * (lift.moment + lift.level * lift.volume) +
           lift.gas * (lift.moment / lift.volume + lift.level);
}

/// The level moves with the skin; it is constant here, because the force does not depend on it.
static void product(const Body* body, double factor, const real4* d, real4* out) {
    Lift lift = lift_of(body);
    lift.of_moment *= factor, lift.of_volume *= factor, lift.gas *= factor;
    const real4* gradient = body->inflation.gradient;
    const double moment_along =
        moment_add_product(body->mesh, body->x, lift.level, d, (real)-lift.of_moment, out);
    measure_volume_product(body->mesh, body->x, d, (real)-lift.of_volume, out);

    double volume_along = 0;
    for (int i = 0; i < body->count; i++)
        volume_along += (double)dot(gradient[i], d[i]);
    const double per_volume2 = lift.gas / (lift.volume * lift.volume);
    const double of_moment = per_volume2 * volume_along;
    const double of_volume =
        per_volume2 * (moment_along - 2 * lift.moment / lift.volume * volume_along);
    moment_add_gradient(body->mesh, body->x, lift.level, (real)-of_moment, out);
    for (int i = 0; i < body->count; i++)
        out[i] -= (real)of_volume * gradient[i];
}

static void update_tangent(Body* body, bool project) {
    (void)project;
    measure_volume_gradient(body->mesh, body->x, body->inflation.gradient);
}

const Force force_lift = {
    .name = "lift",
    .about = "weight of the air outside less that of the gas inside",
    .present = present,
    .add = add,
    .energy = energy,
    .update_tangent = update_tangent,
    .product = product,
    .external = true,
};
