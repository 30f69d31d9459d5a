#include "contact/ccd.h"

#include "contact/triangle_path.h"

enum { MAX_ITERATIONS = 32 };
static const double min_drift = 1e-9; ///< [s] of a drift
static const double rounding = 1e-2;  ///< [radii] more than the distance to a triangle is off by

/// Relative to the ball no point of the triangle moves farther than its fastest corner: a triangle
/// beyond that distance needs no root.
static bool out_of_reach(const Contact* c, double h) {
    const double away = dlength(to_double4(c->lever_arm)) - rounding * (double)c->sphere->radius;
    double fastest2 = 0;
    for (int k = 0; k < 3; k++) {
        const double4 v = to_double4(c->sphere->v) - to_double4(c->body->v[c->particle[k]]);
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
    if (out_of_reach(c, h))
        return false;
    double4 a[3], da[3];
    for (int k = 0; k < 3; k++) {
        const real4 x = c->body->x[c->particle[k]];
        a[k] = to_double4(x);
        da[k] = displacement(x, c->body->v[c->particle[k]], h);
    }
    const real4 x = c->sphere->x;
    return triangle_crossing_time(to_double4(x), displacement(x, c->sphere->v, h), a, da) <= 1;
}

/// Plastic impact: the ball and the triangle's particles get their common linear momentum's
/// velocity, 0 if a particle is held.
static void join(const Contact* c) {
    double mass = (double)c->sphere->mass;
    double4 momentum = mass * to_double4(c->sphere->v);
    bool held = false;
    for (int k = 0; k < 3; k++) {
        const int i = c->particle[k];
        held |= c->body->inverse_mass[i] <= 0;
        mass += (double)c->body->mass[i];
        momentum += (double)c->body->mass[i] * to_double4(c->body->v[i]);
    }
    const real4 v = held ? (real4){0, 0, 0, 0} : to_real4(momentum / mass);
    c->sphere->v = v;
    for (int k = 0; k < 3; k++)
        c->body->v[c->particle[k]] = v;
}

/// Join all pairs that cross until none does. False if the iterations run out.
static bool stop_all(const Contact* near, int count, double h) {
    for (int n = 0; n < MAX_ITERATIONS; n++) {
        bool any = false;
        for (int k = 0; k < count; k++)
            if (ccd_passes_through(&near[k], h)) {
                join(&near[k]);
                any = true;
            }
        if (!any)
            return true;
    }
    return false;
}

double ccd_stop(const Contact* near, int count, double h) {
    while (!stop_all(near, count, h) && h > min_drift)
        h /= 2;
    return h;
}
