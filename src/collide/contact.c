#include "collide/contact.h"

enum { ROUNDS_MOST = 50 };

static const real settled = (real)1e-4; ///< [1] change of a sweep against the largest velocity
static const real way_out = (real)0.2;  ///< [1] part of an overlap that a drift may undo
static const real way_rate = 20; ///< [1/s] and part in a second, so that short drifts do not kick
static const double rounding = 8 * (double)REAL_EPSILON; ///< [1] of the energy that was moved

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

    const real free = 1 / sphere->mass;
    real skin = 0;
    for (int k = 0; k < 3; k++)
        skin += contact.weight[k] * contact.weight[k] * body->inverse_mass[corner[k]];
    contact.compliance = free + skin;
    contact.slide = free + skin + distance * distance / sphere_inertia(sphere);
    return contact;
}

real4 contact_approach(const Contact* c) {
    const real4* v = c->body->v;
    return c->sphere->v + cross(c->sphere->spin, c->arm) - c->weight[0] * v[c->particle[0]] -
           c->weight[1] * v[c->particle[1]] - c->weight[2] * v[c->particle[2]];
}

/// P on the ball at p, -w P on the particles.
static void apply(const Contact* c, real4 impulse) {
    Sphere* s = c->sphere;
    s->v += impulse / s->mass;
    s->spin += cross(c->arm, impulse) / sphere_inertia(s);
    for (int k = 0; k < 3; k++) {
        const int i = c->particle[k];
        c->body->v[i] -= (c->weight[k] * c->body->inverse_mass[i]) * impulse;
    }
}

/// Book the kinetic energy that an impulse adds: met by u along it, and by an inverse mass.
static void book(ContactReport* report, real4 impulse, real4 u, real compliance) {
    const double from = (double)dot(impulse, u);
    const double to = 0.5 * (double)dot(impulse, impulse) * (double)compliance;
    report->kinetic += from + to;
    report->moved += fabs(from) + to;
}

/// One contact's impulse, the others held. Returns the velocity that it changed.
static real improve(Contact* c, real h, real scale, bool rough, ContactReport* report) {
    const real least = c->gap < 0 ? 0 : -c->gap / h;
    const real floor = c->wanted > 0 ? real_max(least, scale * c->wanted) : least;
    const real4 met = contact_approach(c);
    const real push = real_max(0, c->push - (dot(c->normal, met) - floor) / c->compliance);
    const real more = push - c->push;
    if (push <= 0 && more >= 0) // it stays apart, as most of a list do, and cannot rub
        return 0;
    c->push = push;
    real4 impulse = more * c->normal;
    real change = (more < 0 ? -more : more) * c->compliance;
    book(report, impulse, met, c->compliance);

    // against the sliding, which a push along n leaves as it was, within Coulomb's cone
    if (rough && c->sphere->friction > 0) {
        const real4 slide = met - dot(c->normal, met) * c->normal;
        real4 rub = c->rub - slide / c->slide;
        const real size = length(rub), most = c->sphere->friction * push;
        if (size > most)
            rub *= most / size;
        const real4 step = rub - c->rub;
        c->rub = rub;
        impulse += step;
        change = real_max(change, length(step) * c->slide);
        book(report, step, slide, c->slide);
    }
    apply(c, impulse);
    return change;
}

/// Sweeps until nothing changes any more.
static ContactReport sweep_all(Contact* contact, int count, real h, real scale, bool rough) {
    ContactReport report = {0};
    real fastest = 0;
    for (int k = 0; k < count; k++) {
        contact[k].push = 0;
        contact[k].rub = (real4){0, 0, 0, 0};
        fastest = real_max(fastest, length(contact_approach(&contact[k])));
    }
    while (report.rounds < ROUNDS_MOST) {
        real most = 0;
        for (int k = 0; k < count; k++)
            most = real_max(most, improve(&contact[k], h, scale, rough, &report));
        report.rounds++;
        if (most <= settled * fastest)
            break;
    }
    return report;
}

/// Take all impulses back.
static void take_back(Contact* contact, int count) {
    for (int k = count - 1; k >= 0; k--)
        apply(&contact[k], -(contact[k].push * contact[k].normal + contact[k].rub));
}

/// What each contact asks for beyond touching: to bounce at a first hit, to undo an overlap.
static bool ask(Contact* contact, int count, real h) {
    bool any = false;
    for (int k = 0; k < count; k++) {
        Contact* c = &contact[k];
        const real along = dot(c->normal, contact_approach(c));
        c->wanted = c->gap < 0 ? -real_min(way_out / h, way_rate) * c->gap : 0;
        if (c->first && along < 0 && -along * h >= c->gap)
            c->wanted = real_max(c->wanted, -c->sphere->restitution * along);
        any |= c->wanted > 0;
    }
    return any;
}

ContactReport contact_solve(Contact* contact, int count, double step) {
    const real h = (real)step;
    const bool asked = ask(contact, count, h);
    real scale = asked ? 1 : 0;
    for (;;) {
        const ContactReport report = sweep_all(contact, count, h, scale, true);
        if (report.kinetic <= rounding * report.moved)
            return report;
        take_back(contact, count);
        if (scale <= 0) // friction, cut short in its sweeps: without it energy cannot rise
            return sweep_all(contact, count, h, 0, false);
        scale = scale > (real)0.5 ? (real)0.5 : 0;
    }
}
