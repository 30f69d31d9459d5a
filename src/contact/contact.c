#include "contact/contact.h"

#include "base/inertia.h"

enum {
    MAX_ITERATIONS = 50,
    FULL_PASS_INTERVAL = 4, ///< iterations after which inactive contacts are visited again
};

static const real tolerance = (real)1e-3; ///< [1] of the largest initial relative speed
// an overlap is undone by at most a fifth in a drift and at a rate of at most 20 / s, so that short
// drifts give no large speeds
static const real max_overlap_share = (real)0.2; ///< [1]
static const real max_overlap_rate = 20;         ///< [1/s]
static const real max_overlap_radii = 2; ///< [radii/s] nothing is shot out of a deep overlap
static const real max_overlap_speed =
    (real)0.3; ///< [m/s] a whole skin is less than 3 times as fast
/// [1] of the overlap of a ball and a skin that a drift undoes where the contact is in the equation of the
/// step. What slides around a ball within a long step overlaps it; more slowly undone, that grows until
/// the ball is through a ring of the mesh, and its energy is lost.
static const real equation_overlap_share = (real)0.5;

static const double rounding = 8 * (double)REAL_EPSILON; ///< [1] of velocities in a sum

void contact_set_masses(Contact* contact) {
    real others = 0, rotation = 0; // w^2 / m of the nodes after the first, |r|^2 / I
    for (int k = 1; k < contact->node_count; k++)
        others += contact->node[k].weight * contact->node[k].response;
    for (int k = 0; k < contact->lever_count; k++) {
        const ContactLever* lever = &contact->lever[k];
        rotation += dot(lever->arm, lever->arm) * lever->inverse_inertia;
    }
    const real translation = contact->node[0].weight * contact->node[0].response + others;
    contact->normal_mass = 1 / translation; // arms are along n: an impulse along n turns nothing
    contact->tangent_mass = 1 / (translation + rotation);
}

void contact_set_couple(Contact* contact, double4 arm) {
    double4 center = {0}, r[CONTACT_NODES];
    double mass = 0;
    contact->has_couple = false;
    for (int k = 0; k < contact->node_count; k++) {
        r[k] = to_double4(*contact->node[k].position);
        mass += (double)contact->node[k].mass;
        center += (double)contact->node[k].mass * r[k];
    }
    if (!(mass < INFINITY))
        return;
    center /= mass;
    Inertia inertia = {{{0}}}, inverse;
    for (int k = 0; k < contact->node_count; k++)
        inertia_add(&inertia, (double)contact->node[k].mass, r[k] - center);
    if (!inertia_invert(&inertia, &inverse))
        return;
    contact->has_couple = true;
    contact->couple.center = to_real4(center);
    for (int k = 0; k < 3; k++) {
        double4 axis = {0};
        axis[k] = 1;
        contact->couple.column[k] = to_real4(inertia_times(&inverse, dcross(axis, arm)));
    }
}

/// sum_k w_k v_k: u without the spins and the couple, which change u across n only.
static real4 translation(const Contact* c) {
    real4 u = c->node[0].weight * *c->node[0].velocity;
    for (int k = 1; k < c->node_count; k++)
        u += c->node[k].weight * *c->node[k].velocity;
    return u;
}

/// B^T L
static real4 couple(const Contact* c) {
    real4 angular = {0, 0, 0, 0}, u = {0, 0, 0, 0}; // L, without what all velocities have in common
    for (int k = 1; k < c->node_count; k++)
        angular += c->node[k].mass * cross(*c->node[k].position - c->couple.center,
                                           *c->node[k].velocity - *c->node[0].velocity);
    for (int k = 0; k < 3; k++)
        u[k] = dot(c->couple.column[k], angular);
    return u;
}

/// sum_k spin_k x r_k, or B^T L
static real4 rotation(const Contact* c) {
    if (c->has_couple)
        return couple(c);
    real4 u = {0, 0, 0, 0};
    for (int k = 0; k < c->lever_count; k++)
        u += cross(*c->lever[k].spin, c->lever[k].arm);
    return u;
}

real4 contact_relative_velocity(const Contact* c) {
    return translation(c) + rotation(c);
}

/// Apply an impulse at the contact point to all nodes.
static void apply(const Contact* c, real4 impulse) {
    for (int k = 0; k < c->lever_count; k++)
        *c->lever[k].spin += c->lever[k].inverse_inertia * cross(c->lever[k].arm, impulse);
    for (int k = 0; k < c->node_count; k++)
        *c->node[k].velocity += c->node[k].response * impulse;
    for (int k = 0; c->has_couple && k < c->node_count; k++)
        *c->node[k].velocity += contact_couple_velocity(c, impulse, k);
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
        const real4 slide = u - along * c->normal + rotation(c);
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
static real pass(Contact* const* contact, int count, bool all, bool with_friction) {
    real max_change = 0;
    for (int k = 0; k < count; k++)
        if (all || !contact[k]->inactive)
            max_change = real_max(max_change, solve_one(contact[k], with_friction));
    return max_change;
}

/// Lower bounds of n.u' with the bounce and separation scaled by `scale`. Returns the largest
/// initial relative speed.
static real set_min_separation(Contact* const* contact, int count, real h, real scale) {
    real max_speed2 = 0;
    for (int k = 0; k < count; k++) {
        Contact* c = contact[k];
        const real no_overlap = c->gap < 0 ? 0 : -c->gap / h;
        const real overlap_speed = (c->rigid ? 1 : scale) * c->overlap_speed;
        const real separation = real_max(scale * c->bounce_speed, overlap_speed);
        c->min_separation_speed = separation > 0 ? real_max(no_overlap, separation) : no_overlap;
        max_speed2 = real_max(max_speed2, dot(c->initial_velocity, c->initial_velocity));
    }
    return real_sqrt(max_speed2);
}

/// Iterate until a pass over all contacts changes nothing above the tolerance. Returns the passes.
static int iterate(Contact* const* contact, int count, real h, real scale, bool with_friction) {
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
static void undo(Contact* const* contact, int count) {
    for (int k = count - 1; k >= 0; k--) {
        Contact* c = contact[k];
        apply(c, -(c->normal_impulse * c->normal + c->tangent_impulse));
        c->normal_impulse = 0;
        c->tangent_impulse = (real4){0, 0, 0, 0};
    }
}

/// Impulses P between relative velocities u before and u' after change the kinetic energy by
/// sum P.(u + u') / 2, by whatever path they were found. Velocities, and so the energy, are known
/// to rounding.
static ContactReport energy_report(Contact* const* contact, int count) {
    ContactReport report = {0};
    for (int k = 0; k < count; k++) {
        const Contact* c = contact[k];
        if (c->normal_impulse <= 0)
            continue;
        const real4 impulse = c->normal_impulse * c->normal + c->tangent_impulse;
        const double before = (double)dot(impulse, c->initial_velocity);
        const double after = (double)dot(impulse, contact_relative_velocity(c));
        report.kinetic += 0.5 * (before + after);
        report.allowed += rounding * (double)(length(impulse) * length(*c->node[0].velocity));
        if (c->rigid) // this work in the next drift, and half of it in the energy
            report.allowed += (double)(c->normal_impulse * c->overlap_speed);
    }
    return report;
}

real contact_overlap_speed(real gap, real size, real h) {
    const real rate = real_min(max_overlap_share / h, max_overlap_rate);
    const real max = real_min(max_overlap_radii * size, max_overlap_speed);
    return gap < 0 ? real_min(-rate * gap, max) : 0;
}

/// Initial relative velocities, and the separation speeds for a bounce or out of an overlap.
/// Returns whether any contact has one that may be scaled.
static bool set_separation_speeds(Contact* const* contact, int count, real h) {
    bool any = false;
    for (int k = 0; k < count; k++) {
        Contact* c = contact[k];
        c->initial_velocity = contact_relative_velocity(c);
        const real along = dot(c->normal, c->initial_velocity);
        c->overlap_speed = contact_overlap_speed(c->gap, c->size, h);
        const bool bounces = c->first && along < -c->min_bounce_speed && -along * h >= c->gap;
        c->bounce_speed =
            bounces ? real_max(0, -c->restitution * (along + c->fall_speed) - c->fall_speed) : 0;
        any |= c->bounce_speed > 0 || (!c->rigid && c->overlap_speed > 0);
    }
    return any;
}

/// Apply the impulses that the warm start loaded.
static bool apply_warm_start(Contact* const* contact, int count) {
    bool any = false;
    for (int k = 0; k < count; k++) {
        Contact* c = contact[k];
        if (c->normal_impulse <= 0)
            continue;
        c->tangent_impulse -= dot(c->tangent_impulse, c->normal) * c->normal;
        apply(c, c->normal_impulse * c->normal + c->tangent_impulse);
        any = true;
    }
    return any;
}

void contact_set_bounds(Contact* contact, double h) {
    set_separation_speeds(&contact, 1, (real)h);
    if (!contact->rigid)
        contact->bounce_speed = 0;
    if (!contact->rigid && contact->lever_count > 0 && contact->gap < 0)
        contact->overlap_speed =
            real_min(-equation_overlap_share / (real)h * contact->gap, max_overlap_speed);
    set_min_separation(&contact, 1, (real)h, 1);
}

ContactReport contact_solve(Contact* const* contact, int count, double step) {
    const real h = (real)step;
    real scale = set_separation_speeds(contact, count, h) ? 1 : 0;
    bool warm = apply_warm_start(contact, count);
    for (;;) {
        const int iterations = iterate(contact, count, h, scale, true);
        ContactReport report = energy_report(contact, count);
        report.iterations = iterations;
        if (report.kinetic <= report.allowed)
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
