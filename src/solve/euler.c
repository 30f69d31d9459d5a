/// Semi-implicit Euler, the mass-spring paper's own update, in two passes: all forces at the
/// present positions and velocities, then all particles.
///
///     v' = v + h f(x, v) / m
///     x' = x + h v'
///
/// Order 1; keeps linear and angular momentum; on an undamped spring it keeps
/// v^2/2 + w^2 x^2/2 - h w^2 x v/2 exactly. Moving each particle before the next one's force is
/// computed, as the paper's loop read literally would, breaks momentum and is never stable
/// undamped.
#include "force/force.h"
#include "solve/method.h"

static bool kick(Body* body, void* room, double h, Effort* effort) {
    (void)room, (void)effort;
    force_sum(body);
    body_push(body, h);
    return true;
}

/// Stable where the step's matrix on (x, v) has no eigenvalue outside the unit circle:
/// h^2 w^2 + 2 gamma h - 4 <= 0 for explicit damping at the old velocity.
static double limit(double w2, double gamma) {
    if (w2 <= 0)
        return gamma > 0 ? 2 / gamma : INFINITY;
    return (-gamma + sqrt(gamma * gamma + 4 * w2)) / w2;
}

const Method method_euler = {
    .name = "euler",
    .about = "semi-implicit Euler, order 1: all forces, then all particles",
    .kick = kick,
    .drift = body_drift,
    .limit = limit,
};
