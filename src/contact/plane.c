#include "contact/plane.h"

#include "contact/contact.h"

double plane_box_gap(const Plane* plane, const Extent* x) {
    double4 nearest = {0};
    for (int k = 0; k < 3; k++)
        nearest[k] = (double)(plane->normal[k] > 0 ? x->low[k] : x->high[k]);
    return ddot(plane->normal, nearest - plane->point);
}

bool plane_within(const Plane* plane, const Extent* x, const Extent* v, double h) {
    // twice the way, as plane_stop has it; written so that a NaN is within
    return !(plane_box_gap(plane, x) > 2 * extent_length(v) * h);
}

double plane_stop(Body* body, const Plane* plane, double step, double* work) {
    const real h = (real)step;
    const real4 n = to_real4(plane->normal), point = to_real4(plane->point);
    double impulse = 0;
    for (int i = 0; i < body->count; i++) {
        const real gap = dot(n, body->x[i] - point);
        const real along = dot(n, body->v[i]);
        if (gap > 0 && gap > -2 * along * h) // the most are far away, and need no division
            continue;
        const real out = gap > 0 ? -gap / h : contact_overlap_speed(gap, (real)INFINITY, h);
        const real stop = out - along;
        if (stop <= 0 || body->inverse_mass[i] <= 0)
            continue;

        const real4 slide = body->v[i] - along * n;
        const real speed = length(slide);
        const real kept = speed > plane->friction * stop ? 1 - plane->friction * stop / speed : 0;
        body->v[i] = (along + stop) * n + kept * slide;
        impulse += (double)(body->mass[i] * stop);
        if (gap < 0)
            *work += fmax(0, (double)(body->mass[i] * stop * (along + out) / 2));
    }
    return impulse;
}
