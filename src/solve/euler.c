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
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "force/force.h"
#include "solve/method.h"

/// Positions at the start of a step, [count] of real4, where particles move in place; else NULL.
static void* open(Body* body, const Solver* solver) {
    return solver->in_place ? new_array(real4, body->count) : NULL;
}

/// The paper's loop to the letter: all forces are computed anew for each particle. It is meant for
/// small skins, to show how it fails.
static void kick_in_place(Body* body, real4* start, double h) {
    memcpy(start, body->x, (size_t)body->count * sizeof *start);
    for (int i = 0; i < body->count; i++) {
        force_sum(body);
        body->v[i] += ((real)h * body->inverse_mass[i]) * body->f[i];
        body->x[i] += (real)h * body->v[i];
    }
    memcpy(body->x, start, (size_t)body->count * sizeof *start); // the drift is to come
}

static bool kick_body(Body* body, void* workspace, double h, SolveStats* stats) {
    (void)stats;
    if (workspace) {
        kick_in_place(body, workspace, h);
        return true;
    }
    force_push(body, h);
    return true;
}

/// One mode of squared frequency w2 and damping rate gamma, v' = v - h (w2 x + gamma v) and
/// x' = x + h v', is a linear map of (x, v) with determinant and trace
///
///     D = 1 - h gamma,   T = 2 - h gamma - h^2 w2
///
/// and the characteristic polynomial z^2 - T z + D. Both roots are in the unit circle where D <= 1
/// and |T| <= 1 + D (Jury's criterion); the second is the narrower one, -T <= 1 + D:
///
///     h^2 w2 + 2 gamma h - 4 <= 0   or   h <= (-gamma + sqrt(gamma^2 + 4 w2)) / w2
static double limit(double w2, double gamma) {
    if (w2 <= 0)
        return gamma > 0 ? 2 / gamma : INFINITY;
    return (-gamma + sqrt(gamma * gamma + 4 * w2)) / w2;
}

const Method method_euler = {
    .name = "euler",
    .about = "semi-implicit Euler, order 1: all forces, then all particles",
    .staggered = true, // a leapfrog, whose v is that of t - h/2
    .joins = true,
    .open = open,
    .close = free,
    .kick = system_kick,
    .kick_body = kick_body,
    .drift = body_drift,
    .limit = limit,
};
