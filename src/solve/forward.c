/// Forward Euler: positions and velocities both from the start of the step.
///
///     x' = x + h v
///     v' = v + h f(x, v) / m
///
/// Order 1. On an undamped mode of frequency w each step multiplies the amplitude by
/// sqrt(1 + h^2 w^2): it is never stable without damping, and is kept to show that. The kick only
/// computes the forces; the drift moves by the old velocities, after strain limits and contacts,
/// and then applies the forces, so that between steps x and v belong to the same time.
#include "force/force.h"
#include "solve/method.h"

static bool kick_body(Body* body, void* workspace, double h, SolveStats* stats) {
    (void)workspace, (void)h, (void)stats;
    force_sum(body);
    return true;
}

static void drift(Body* body, double h) {
    body_drift(body, h);
    body_push(body, h);
}

/// (1 + h z) stays in the unit circle for both roots of z^2 + gamma z + w^2 = 0, where an
/// oscillating mode has |1 + h z|^2 = 1 - gamma h + w^2 h^2, and for free motion, z = -gamma.
static double limit(double w2, double gamma) {
    if (gamma <= 0)
        return w2 > 0 ? 0 : INFINITY;
    const double discriminant = gamma * gamma - 4 * w2;
    return fmin(2 / gamma, discriminant < 0 ? gamma / w2 : 4 / (gamma + sqrt(discriminant)));
}

const Method method_forward = {
    .name = "forward",
    .about = "forward Euler, order 1: explodes without damping, kept to show where",
    .kick = system_kick,
    .kick_body = kick_body,
    .drift = drift,
    .limit = limit,
};
