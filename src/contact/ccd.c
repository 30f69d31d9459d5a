#include "contact/ccd.h"

#include "contact/triangle_path.h"

enum { MAX_ITERATIONS = 32 };
static const double min_drift = 1e-9; ///< [s] of a drift
static const double rounding = 1e-2;  ///< [radii] more than the distance to a triangle is off by

/// Relative to the point no point of the triangle moves farther than its fastest corner: a triangle
/// beyond that distance needs no root.
static bool out_of_reach(const Contact* c, double h) {
    const double away = dlength(to_double4(c->lever[0].arm)) - rounding * (double)c->size;
    double fastest2 = 0;
    for (int k = 1; k < c->node_count; k++) {
        const double4 v = to_double4(*c->node[0].velocity) - to_double4(*c->node[k].velocity);
        fastest2 = fmax(fastest2, ddot(v, v));
    }
    return away > 0 && h * h * fastest2 < away * away;
}

/// Displacement of a drift as the state's precision rounds it: a centre pressed onto a triangle
/// must not change sides by rounding.
static double4 displacement(real4 x, real4 v, double h) {
    return to_double4(x + (real)h * v) - to_double4(x);
}

bool ccd_passes_through(const Contact* c, double h) {
    if (c->node_count < CONTACT_NODES || c->lever_count == 0 || out_of_reach(c, h))
        return false;
    double4 x[CONTACT_NODES], dx[CONTACT_NODES];
    for (int k = 0; k < CONTACT_NODES; k++) {
        x[k] = to_double4(*c->node[k].position);
        dx[k] = displacement(*c->node[k].position, *c->node[k].velocity, h);
    }
    return triangle_crossing_time(x[0], dx[0], x + 1, dx + 1) <= 1;
}

/// Plastic impact: all nodes get their common linear momentum's velocity, or that of one that is held.
static void join(const Contact* c) {
    double mass = 0;
    double4 momentum = {0};
    const ContactNode* held = NULL;
    for (int k = 0; k < c->node_count; k++) {
        mass += (double)c->node[k].mass;
        momentum += (double)c->node[k].mass * to_double4(*c->node[k].velocity);
        if (!((double)c->node[k].mass < INFINITY))
            held = &c->node[k];
    }
    const real4 v = held ? *held->velocity : to_real4(momentum / mass);
    for (int k = 0; k < c->node_count; k++)
        *c->node[k].velocity = v;
}

/// Join the pairs that cross. Returns whether any did.
static bool join_crossing(const Contact* list, int count, double h) {
    bool any = false;
    for (int k = 0; k < count; k++)
        if (ccd_passes_through(&list[k], h)) {
            join(&list[k]);
            any = true;
        }
    return any;
}

/// Join all pairs that cross until none does. False if the iterations run out.
static bool stop_all(const Contact* contact, int count, const Contact* near, int near_count,
                     double h) {
    for (int n = 0; n < MAX_ITERATIONS; n++) {
        const bool crossed = join_crossing(contact, count, h);
        if (!join_crossing(near, near_count, h) && !crossed)
            return true;
    }
    return false;
}

double ccd_stop(const Contact* contact, int count, const Contact* near, int near_count, double h) {
    while (!stop_all(contact, count, near, near_count, h) && h > min_drift)
        h /= 2;
    return h;
}
