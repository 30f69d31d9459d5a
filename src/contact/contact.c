#include "contact/contact.h"

enum {
    ROUNDS_MOST = 50,
    EACH_LOOKED_AT = 4, ///< rounds after which those that do not push are looked at again
};

static const real settled = (real)1e-3; ///< [1] change of a sweep against the largest velocity
static const real way_out = (real)0.2;  ///< [1] part of an overlap that a drift may undo
static const real way_rate = 20; ///< [1/s] and part in a second, so that short drifts do not kick
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
    Contact contact = {.sphere = sphere,
                       .body = body,
                       .triangle = triangle,
                       .particle = {corner[0], corner[1], corner[2]}};
    nearest(sphere->x, a, b, c, contact.weight);

    const real4 p = contact.weight[0] * a + contact.weight[1] * b + contact.weight[2] * c;
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
    contact.arm = -distance * contact.normal;

    real skin = 0;
    for (int k = 0; k < 3; k++) {
        contact.share[k] = contact.weight[k] * body->inverse_mass[corner[k]];
        skin += contact.weight[k] * contact.share[k];
    }
    contact.free = 1 / sphere->mass;
    contact.turn = 1 / sphere_inertia(sphere);
    contact.give = 1 / (contact.free + skin);
    contact.grip = 1 / (contact.free + skin + distance * distance * contact.turn);
    return contact;
}

/// u but for the ball's spin, which moves p across n only.
static real4 slip(const Contact* c) {
    const real4* v = c->body->v;
    return c->sphere->v - c->weight[0] * v[c->particle[0]] - c->weight[1] * v[c->particle[1]] -
           c->weight[2] * v[c->particle[2]];
}

real4 contact_approach(const Contact* c) {
    return slip(c) + cross(c->sphere->spin, c->arm);
}

/// P on the ball at p, -w P on the particles.
static void apply(const Contact* c, real4 impulse) {
    c->sphere->v += c->free * impulse;
    c->sphere->spin += c->turn * cross(c->arm, impulse);
    for (int k = 0; k < 3; k++)
        c->body->v[c->particle[k]] -= c->share[k] * impulse;
}

/// One contact's impulse, the others held. Returns the velocity that it changed.
static real improve(Contact* c, bool rough) {
    const real4 met = slip(c);
    const real along = dot(c->normal, met);
    const real push = real_max(0, c->push - (along - c->floor) * c->give);
    c->resting = push <= 0;
    if (push <= 0 && c->push <= 0) // it stays apart, as most of a list do, and cannot rub
        return 0;
    const real more = push - c->push;
    c->push = push;
    real4 impulse = more * c->normal;
    real change = (more < 0 ? -more : more) / c->give;

    // against the sliding, which a push along n leaves as it was, within Coulomb's cone
    if (rough && c->sphere->friction > 0) {
        const real4 slide = met - along * c->normal + cross(c->sphere->spin, c->arm);
        real4 rub = c->rub - c->grip * slide;
        const real size = length(rub), most = c->sphere->friction * push;
        if (size > most)
            rub *= most / size;
        const real4 step = rub - c->rub;
        c->rub = rub;
        impulse += step;
        change = real_max(change, length(step) / c->grip);
    }
    apply(c, impulse);
    return change;
}

/// A round over all contacts, or over those that pushed when last looked at. Returns the largest
/// velocity that it changed.
static real sweep(Contact* contact, int count, bool all, bool rough) {
    real most = 0;
    for (int k = 0; k < count; k++)
        if (all || !contact[k].resting)
            most = real_max(most, improve(&contact[k], rough));
    return most;
}

/// Rounds until nothing changes any more. Returns how many.
static int sweep_all(Contact* contact, int count, real h, real scale, bool rough) {
    real fastest = 0;
    for (int k = 0; k < count; k++) {
        Contact* c = &contact[k];
        const real least = c->gap < 0 ? 0 : -c->gap / h;
        c->floor = c->wanted > 0 ? real_max(least, scale * c->wanted) : least;
        fastest = real_max(fastest, dot(c->arrival, c->arrival));
    }
    fastest = real_sqrt(fastest);
    bool all = true;
    int rounds = 0;
    while (rounds < ROUNDS_MOST) {
        const real most = sweep(contact, count, all, rough);
        rounds++;
        if (most > settled * fastest)
            all = rounds % EACH_LOOKED_AT == 0;
        else if (all)
            break;
        else
            all = true;
    }
    return rounds;
}

/// Take all impulses back.
static void take_back(Contact* contact, int count) {
    for (int k = count - 1; k >= 0; k--) {
        apply(&contact[k], -(contact[k].push * contact[k].normal + contact[k].rub));
        contact[k].push = 0;
        contact[k].rub = (real4){0, 0, 0, 0};
    }
}

/// The energy of impulses P between velocities u before and u' after is P.(u + u')/2, whatever the
/// way they were found; velocities, and so the energy, are known to their rounding.
static ContactReport book(const Contact* contact, int count) {
    ContactReport report = {0};
    for (int k = 0; k < count; k++) {
        const Contact* c = &contact[k];
        if (c->push <= 0)
            continue;
        const real4 impulse = c->push * c->normal + c->rub;
        const double before = (double)dot(impulse, c->arrival);
        const double after = (double)dot(impulse, contact_approach(c));
        report.kinetic += 0.5 * (before + after);
        report.moved += 0.5 * (fabs(before) + fabs(after));
        report.rounded += rounding * (double)(length(impulse) * length(c->sphere->v));
    }
    return report;
}

/// What each contact asks for beyond touching: to bounce at a first hit, to undo an overlap.
static bool ask(Contact* contact, int count, real h) {
    bool any = false;
    for (int k = 0; k < count; k++) {
        Contact* c = &contact[k];
        c->arrival = contact_approach(c);
        const real along = dot(c->normal, c->arrival);
        c->wanted = c->gap < 0 ? -real_min(way_out / h, way_rate) * c->gap : 0;
        if (c->first && along < -c->least && -along * h >= c->gap)
            c->wanted = real_max(c->wanted, -c->sphere->restitution * along);
        any |= c->wanted > 0;
    }
    return any;
}

/// Begin with the impulses that the contacts were given.
static bool start_warm(Contact* contact, int count) {
    bool any = false;
    for (int k = 0; k < count; k++) {
        Contact* c = &contact[k];
        if (c->push <= 0)
            continue;
        c->rub -= dot(c->rub, c->normal) * c->normal;
        apply(c, c->push * c->normal + c->rub);
        any = true;
    }
    return any;
}

ContactReport contact_solve(Contact* contact, int count, double step) {
    const real h = (real)step;
    real scale = ask(contact, count, h) ? 1 : 0;
    bool warm = start_warm(contact, count);
    for (;;) {
        const int rounds = sweep_all(contact, count, h, scale, true);
        ContactReport report = book(contact, count);
        report.rounds = rounds;
        if (report.kinetic <= report.rounded)
            return report;
        take_back(contact, count);
        if (warm) { // what was remembered may be far off: without it
            warm = false;
            continue;
        }
        if (scale <= 0) { // friction, cut short in its sweeps: without it energy cannot rise
            sweep_all(contact, count, h, 0, false);
            return book(contact, count);
        }
        scale = scale > (real)0.5 ? (real)0.5 : 0;
    }
}
