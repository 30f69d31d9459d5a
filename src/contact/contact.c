#include "contact/contact.h"

enum {
    MAX_ITERATIONS = 50,
    FULL_PASS_INTERVAL = 4, ///< iterations after which inactive contacts are visited again
};

static const real tolerance = (real)1e-3; ///< [1] of the largest initial relative speed
// an overlap is undone by at most a fifth in a drift and at a rate of at most 20 / s, so that short
// drifts give no large speeds
static const real max_overlap_share = (real)0.2;         ///< [1]
static const real max_overlap_rate = 20;                 ///< [1/s]
static const double rounding = 8 * (double)REAL_EPSILON; ///< [1] of velocities in a sum

/// Weights of the point of triangle (a, b, c) nearest p.
/// Source: C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
static void nearest(real4 p, real4 a, real4 b, real4 c, real weight[3]) {
    const real4 ab = b - a, ac = c - a, ap = p - a;
    const real d1 = dot(ab, ap), d2 = dot(ac, ap);
    weight[0] = 1, weight[1] = 0, weight[2] = 0;
    if (d1 <= 0 && d2 <= 0)
        return;

    const real4 bp = p - b;
    const real d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) {
        weight[0] = 0, weight[1] = 1;
        return;
    }
    const real vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        weight[1] = d1 / (d1 - d3);
        weight[0] = 1 - weight[1];
        return;
    }

    const real4 cp = p - c;
    const real d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) {
        weight[0] = 0, weight[2] = 1;
        return;
    }
    const real vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        weight[2] = d2 / (d2 - d6);
        weight[0] = 1 - weight[2];
        return;
    }
    const real va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        weight[2] = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        weight[1] = 1 - weight[2];
        weight[0] = 0;
        return;
    }
    weight[1] = vb / (va + vb + vc);
    weight[2] = vc / (va + vb + vc);
    weight[0] = 1 - weight[1] - weight[2];
}

Contact contact_make(Sphere* sphere, Body* body, int triangle, real side) {
    const int* corner = body->mesh->triangle[triangle];
    const real4 a = body->x[corner[0]], b = body->x[corner[1]], c = body->x[corner[2]];
    real4* v = body->v;
    Contact contact = {.velocity = {&sphere->v, &v[corner[0]], &v[corner[1]], &v[corner[2]]},
                       .spin = &sphere->spin,
                       .friction = sphere->friction,
                       .restitution = sphere->restitution,
                       .sphere = sphere,
                       .body = body,
                       .triangle = triangle,
                       .particle = {corner[0], corner[1], corner[2]}};
    real weight[3];
    nearest(sphere->x, a, b, c, weight);

    const real4 p = weight[0] * a + weight[1] * b + weight[2] * c;
    const real4 away = sphere->x - p;
    const real distance = length(away);
    if (distance > (real)1e-6 * sphere->radius) {
        contact.normal = away / distance;
    } else {
        const real4 across = cross(b - a, c - a);
        const real area = length(across);
        contact.normal = area > 0 ? side / area * across : (real4){0, side, 0, 0};
    }
    contact.gap = distance - sphere->radius;
    contact.lever_arm = -distance * contact.normal;

    // effective masses 1 / (n . M^-1 n)
    real skin = 0;
    for (int k = 0; k < 3; k++) {
        contact.weight[k + 1] = -weight[k];
        contact.inverse_mass[k + 1] = -weight[k] * body->inverse_mass[corner[k]];
        skin -= weight[k] * contact.inverse_mass[k + 1];
    }
    contact.weight[0] = 1;
    contact.inverse_mass[0] = 1 / sphere->mass;
    contact.inverse_inertia = 1 / sphere_inertia(sphere);
    contact.normal_mass = 1 / (contact.inverse_mass[0] + skin);
    contact.tangent_mass =
        1 / (contact.inverse_mass[0] + skin + distance * distance * contact.inverse_inertia);
    return contact;
}

/// sum_k w_k v_k: u without the spin, which changes u across n only.
static real4 translation(const Contact* c) {
    return *c->velocity[0] + c->weight[1] * *c->velocity[1] + c->weight[2] * *c->velocity[2] +
           c->weight[3] * *c->velocity[3];
}

real4 contact_relative_velocity(const Contact* c) {
    return translation(c) + cross(*c->spin, c->lever_arm);
}

/// Apply an impulse at the contact point to all nodes.
static void apply(const Contact* c, real4 impulse) {
    *c->spin += c->inverse_inertia * cross(c->lever_arm, impulse);
    for (int k = 0; k < CONTACT_NODES; k++)
        *c->velocity[k] += c->inverse_mass[k] * impulse;
}

/// Solve one contact for its impulse, the others held. Returns the change of velocity.
static real solve_one(Contact* c, bool with_friction) {
    const real4 u = translation(c);
    const real along = dot(c->normal, u);
    const real normal_impulse =
        real_max(0, c->normal_impulse - (along - c->min_separation_speed) * c->normal_mass);
    c->inactive = normal_impulse <= 0;
    if (normal_impulse <= 0 && c->normal_impulse <= 0) // most contacts of a list stay apart
        return 0;
    const real change = normal_impulse - c->normal_impulse;
    c->normal_impulse = normal_impulse;
    real4 impulse = change * c->normal;
    real max_change = (change < 0 ? -change : change) / c->normal_mass;

    // projected on Coulomb's cone; an impulse along n leaves the tangential velocity as it was
    if (with_friction && c->friction > 0) {
        const real4 slide = u - along * c->normal + cross(*c->spin, c->lever_arm);
        real4 tangent_impulse = c->tangent_impulse - c->tangent_mass * slide;
        const real size = length(tangent_impulse), bound = c->friction * normal_impulse;
        if (size > bound)
            tangent_impulse *= bound / size;
        const real4 tangent_change = tangent_impulse - c->tangent_impulse;
        c->tangent_impulse = tangent_impulse;
        impulse += tangent_change;
        max_change = real_max(max_change, length(tangent_change) / c->tangent_mass);
    }
    apply(c, impulse);
    return max_change;
}

/// One Gauss-Seidel pass over all contacts, or over those not inactive. Returns the largest change
/// of velocity.
static real pass(Contact* contact, int count, bool all, bool with_friction) {
    real max_change = 0;
    for (int k = 0; k < count; k++)
        if (all || !contact[k].inactive)
            max_change = real_max(max_change, solve_one(&contact[k], with_friction));
    return max_change;
}

/// Lower bounds of n.u' with the bounce and separation scaled by `scale`. Returns the largest
/// initial relative speed.
static real set_min_separation(Contact* contact, int count, real h, real scale) {
    real max_speed2 = 0;
    for (int k = 0; k < count; k++) {
        Contact* c = &contact[k];
        const real no_overlap = c->gap < 0 ? 0 : -c->gap / h;
        c->min_separation_speed = c->separation_speed > 0
                                      ? real_max(no_overlap, scale * c->separation_speed)
                                      : no_overlap;
        max_speed2 = real_max(max_speed2, dot(c->initial_velocity, c->initial_velocity));
    }
    return real_sqrt(max_speed2);
}

/// Iterate until a pass over all contacts changes nothing above the tolerance. Returns the passes.
static int iterate(Contact* contact, int count, real h, real scale, bool with_friction) {
    const real max_speed = set_min_separation(contact, count, h, scale);
    bool all = true;
    int iterations = 0;
    while (iterations < MAX_ITERATIONS) {
        const real max_change = pass(contact, count, all, with_friction);
        iterations++;
        if (max_change > tolerance * max_speed)
            all = iterations % FULL_PASS_INTERVAL == 0;
        else if (all)
            break;
        else
            all = true;
    }
    return iterations;
}

/// Subtract all impulses from the velocities.
static void undo(Contact* contact, int count) {
    for (int k = count - 1; k >= 0; k--) {
        Contact* c = &contact[k];
        apply(c, -(c->normal_impulse * c->normal + c->tangent_impulse));
        c->normal_impulse = 0;
        c->tangent_impulse = (real4){0, 0, 0, 0};
    }
}

/// Impulses P between relative velocities u before and u' after change the kinetic energy by
/// sum P.(u + u') / 2, by whatever path they were found. Velocities, and so the energy, are known
/// to rounding.
static ContactReport energy_report(const Contact* contact, int count) {
    ContactReport report = {0};
    for (int k = 0; k < count; k++) {
        const Contact* c = &contact[k];
        if (c->normal_impulse <= 0)
            continue;
        const real4 impulse = c->normal_impulse * c->normal + c->tangent_impulse;
        const double before = (double)dot(impulse, c->initial_velocity);
        const double after = (double)dot(impulse, contact_relative_velocity(c));
        report.kinetic += 0.5 * (before + after);
        report.moved += 0.5 * (fabs(before) + fabs(after));
        report.rounded += rounding * (double)(length(impulse) * length(*c->velocity[0]));
    }
    return report;
}

/// Initial relative velocities, and the separation speeds for a bounce or out of an overlap.
/// Returns whether any contact has one.
static bool set_separation_speeds(Contact* contact, int count, real h) {
    bool any = false;
    for (int k = 0; k < count; k++) {
        Contact* c = &contact[k];
        c->initial_velocity = contact_relative_velocity(c);
        const real along = dot(c->normal, c->initial_velocity);
        c->separation_speed =
            c->gap < 0 ? -real_min(max_overlap_share / h, max_overlap_rate) * c->gap : 0;
        if (c->first && along < -c->min_bounce_speed && -along * h >= c->gap)
            c->separation_speed = real_max(c->separation_speed, -c->restitution * along);
        any |= c->separation_speed > 0;
    }
    return any;
}

/// Apply the impulses that the warm start loaded.
static bool apply_warm_start(Contact* contact, int count) {
    bool any = false;
    for (int k = 0; k < count; k++) {
        Contact* c = &contact[k];
        if (c->normal_impulse <= 0)
            continue;
        c->tangent_impulse -= dot(c->tangent_impulse, c->normal) * c->normal;
        apply(c, c->normal_impulse * c->normal + c->tangent_impulse);
        any = true;
    }
    return any;
}

ContactReport contact_solve(Contact* contact, int count, double step) {
    const real h = (real)step;
    real scale = set_separation_speeds(contact, count, h) ? 1 : 0;
    bool warm = apply_warm_start(contact, count);
    for (;;) {
        const int iterations = iterate(contact, count, h, scale, true);
        ContactReport report = energy_report(contact, count);
        report.iterations = iterations;
        if (report.kinetic <= report.rounded)
            return report;
        undo(contact, count);
        if (warm) { // the warm start may be far off: again without it
            warm = false;
            continue;
        }
        if (scale <= 0) { // friction that has not converged: without it energy cannot rise
            iterate(contact, count, h, 0, false);
            return energy_report(contact, count);
        }
        scale = scale > (real)0.5 ? (real)0.5 : 0;
    }
}
