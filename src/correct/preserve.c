#include "correct/preserve.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "force/material.h"

static const double enough = 1e-12; ///< of the rubber's volume [1]
enum { PASSES_MOST = 20 };          ///< two or three are usual

void preserve_open(Preserve* preserve, const Body* body) {
    *preserve = (Preserve){0};
    const Membrane* membrane = &body->membrane;
    if (membrane->count == 0 || membrane->rubber.rule == VOLUME_LOCAL)
        return;
    preserve->moved = new_array(real4, body->count);
    preserve->gradient = new_array(real4, body->count);
    preserve->weight = new_array(real, body->count);
    preserve->share = new_array(double, membrane->count);
    preserve->thickness = new_array(double, membrane->count);

    // half of the mass stays with the particles, half goes to the virtual vertices
    double* mass = new_array(double, body->count);
    membrane_add_mass(membrane, mass);
    for (int i = 0; i < body->count; i++)
        preserve->weight[i] = body->inverse_mass[i] > 0 ? (real)(2 / mass[i]) : 0;
    free(mass);
    for (int e = 0; e < membrane->count; e++)
        preserve->share[e] = membrane_share(membrane, e);
}

/// Weight of the virtual vertex: half of the element's rubber.
static inline real virtual_weight(const Membrane* membrane, int e) {
    return 2 / ((real)membrane->rubber.density * membrane->rest[e][3]);
}

/// An edge now: what is moved may be far below the last bit of a position.
static inline real4 edge(const Preserve* preserve, const real4* x, int from, int to) {
    return (x[to] - x[from]) + (preserve->moved[to] - preserve->moved[from]);
}

/// C, its gradient by the particles, and the sum of w |dC|^2.
static double constraint(const Membrane* membrane, Preserve* preserve, const real4* restrict x,
                         int count, double* sum) {
    real4* restrict gradient = preserve->gradient;
    double volume = 0;
    *sum = 0;
    memset(gradient, 0, (size_t)count * sizeof *gradient);
    for (int e = 0; e < membrane->count; e++) {
        const int* c = membrane->corner[e];
        const real4 ab = edge(preserve, x, c[0], c[1]), ac = edge(preserve, x, c[0], c[2]);
        const real4 normal = cross(ab, ac);
        const real twice = length(normal), half = (real)preserve->share[e] / 2;
        volume += preserve->share[e] / 2 * preserve->thickness[e] * (double)twice;
        const real4 up = half * (real)preserve->thickness[e] / twice * normal;
        const real4 by_b = cross(ac, up), by_c = cross(up, ab);
        const real4 by_middle = half / 3 * normal; // c moves under x4
        gradient[c[0]] -= by_b + by_c + by_middle;
        gradient[c[1]] += by_b - by_middle;
        gradient[c[2]] += by_c - by_middle;
        *sum += (double)(virtual_weight(membrane, e) * half * half * twice * twice);
    }
    for (int i = 0; i < count; i++)
        *sum += (double)(preserve->weight[i] * dot(gradient[i], gradient[i]));
    return volume - membrane->volume;
}

/// Move everything by lambda times weight times gradient, and read the thickness off: with n the
/// normal before, n + m after, what x4 rose over the middle is, without what cancels,
///
///     (x4 - x_a) . (n + m)^ - h = ((e12 + e13)/3 . m - dx_a . (n + m)) / |n + m|
///                                 + dx4 (n . (n + m)) / |n + m| + h (cos - 1)
static void move(const Membrane* membrane, Preserve* preserve, const real4* restrict x, int count,
                 real lambda) {
    real4* restrict way = preserve->gradient;
    for (int i = 0; i < count; i++)
        way[i] *= lambda * preserve->weight[i];
    for (int e = 0; e < membrane->count; e++) {
        const int* c = membrane->corner[e];
        const real4 ab = edge(preserve, x, c[0], c[1]), ac = edge(preserve, x, c[0], c[2]);
        const real4 db = way[c[1]] - way[c[0]], dc = way[c[2]] - way[c[0]];
        const real4 before = cross(ab, ac), turn = cross(ab, dc) + cross(db, ac + dc);
        const real4 after = before + turn, across = cross(before, turn);
        const real square = dot(after, after);
        const real sine = dot(across, across) / (dot(before, before) * square); // squared
        const real top = lambda * virtual_weight(membrane, e) * (real)preserve->share[e] / 2;
        const real rise = dot(ab + ac, turn) / 3 - dot(way[c[0]], after) + top * dot(before, after);
        preserve->thickness[e] +=
            (double)(rise / real_sqrt(square)) -
            preserve->thickness[e] * (double)(sine / (1 + real_sqrt(1 - sine)));
    }
    for (int i = 0; i < count; i++)
        preserve->moved[i] += way[i];
}

static void preserve_sum(Preserve* preserve, Body* body, double h) {
    Membrane* membrane = &body->membrane;
    memset(preserve->moved, 0, (size_t)body->count * sizeof *preserve->moved);
    for (int e = 0; e < membrane->count; e++)
        preserve->thickness[e] = (double)membrane->thickness[e];
    for (preserve->passes = 0; preserve->passes < PASSES_MOST; preserve->passes++) {
        double sum;
        const double c = constraint(membrane, preserve, body->x, body->count, &sum);
        if (!(fabs(c) > enough * membrane->volume))
            break;
        move(membrane, preserve, body->x, body->count, (real)(-c / sum));
    }
    for (int i = 0; i < body->count; i++) {
        body->v[i] += preserve->moved[i] / (real)h;
        body->x[i] += preserve->moved[i];
    }
    for (int e = 0; e < membrane->count; e++)
        membrane->thickness[e] = (real)preserve->thickness[e];
}

void preserve_volume(Preserve* preserve, Body* body, double h) {
    Membrane* membrane = &body->membrane;
    if (membrane->count == 0)
        return;
    if (membrane->rubber.rule == VOLUME_GLOBAL)
        preserve_sum(preserve, body, h);
    else if (membrane->rubber.material->reads_thickness)
        for (int e = 0; e < membrane->count; e++)
            membrane->thickness[e] = (real)membrane_thickness(membrane, body->x, e);
}

void preserve_close(Preserve* preserve) {
    free(preserve->moved);
    free(preserve->gradient);
    free(preserve->weight);
    free(preserve->share);
    free(preserve->thickness);
    *preserve = (Preserve){0};
}
