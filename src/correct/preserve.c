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
    preserve->x = new_array(double4, body->count);
    preserve->gradient = new_array(double4, body->count);
    preserve->weight = new_array(double, body->count);
    preserve->thickness = new_array(double, membrane->count);

    // half of the mass stays with the particles, half goes to the virtual vertices
    membrane_add_mass(membrane, preserve->weight);
    for (int i = 0; i < body->count; i++)
        preserve->weight[i] = body->inverse_mass[i] > 0 ? 2 / preserve->weight[i] : 0;
}

/// An element on the way: its corners, twice its area vector, and h n.
typedef struct Prism {
    const int* corner;
    double4 ab, ac, normal, up;
    double share;
} Prism;

static Prism prism_of(const Membrane* membrane, const Preserve* preserve, int e) {
    const int* c = membrane->corner[e];
    Prism prism = {.corner = c, .share = membrane_share(membrane, e)};
    prism.ab = preserve->x[c[1]] - preserve->x[c[0]];
    prism.ac = preserve->x[c[2]] - preserve->x[c[0]];
    prism.normal = dcross(prism.ab, prism.ac);
    prism.up = preserve->thickness[e] / dlength(prism.normal) * prism.normal;
    return prism;
}

/// Weight of the virtual vertex: half of the element's rubber.
static double virtual_weight(const Membrane* membrane, int e) {
    return 2 / (membrane->rubber.density * (double)membrane->rest[e][3]);
}

/// C, its gradient by the particles, and the sum of w |dC|^2.
static double constraint(const Membrane* membrane, Preserve* preserve, int count, double* sum) {
    double volume = 0;
    *sum = 0;
    memset(preserve->gradient, 0, (size_t)count * sizeof *preserve->gradient);
    for (int e = 0; e < membrane->count; e++) {
        const Prism p = prism_of(membrane, preserve, e);
        volume += p.share * ddot(p.up, p.normal) / 2;
        const double4 by_b = p.share / 2 * dcross(p.ac, p.up);
        const double4 by_c = p.share / 2 * dcross(p.up, p.ab);
        const double4 by_middle = p.share / 6 * p.normal; // c moves under x4
        preserve->gradient[p.corner[0]] -= by_b + by_c + by_middle;
        preserve->gradient[p.corner[1]] += by_b - by_middle;
        preserve->gradient[p.corner[2]] += by_c - by_middle;
        *sum += virtual_weight(membrane, e) * p.share * p.share * ddot(p.normal, p.normal) / 4;
    }
    for (int i = 0; i < count; i++)
        *sum += preserve->weight[i] * ddot(preserve->gradient[i], preserve->gradient[i]);
    return volume - membrane->volume;
}

/// Move everything by lambda times weight times gradient, and read the thickness off.
static void move(const Membrane* membrane, Preserve* preserve, int count, double lambda) {
    // x4 as seen from the first corner, before that corner moves
    for (int e = 0; e < membrane->count; e++) {
        const Prism p = prism_of(membrane, preserve, e);
        const double4 by_top = p.share / 2 * p.normal;
        const double4 top =
            (p.ab + p.ac) / 3 + p.up + lambda * virtual_weight(membrane, e) * by_top;
        double4 corner[3];
        for (int k = 0; k < 3; k++) {
            const int i = p.corner[k];
            corner[k] = preserve->x[i] + lambda * preserve->weight[i] * preserve->gradient[i];
        }
        const double4 normal = dcross(corner[1] - corner[0], corner[2] - corner[0]);
        const double4 from_corner = preserve->x[p.corner[0]] + top - corner[0];
        preserve->thickness[e] = ddot(from_corner, normal) / dlength(normal);
    }
    for (int i = 0; i < count; i++)
        preserve->x[i] += lambda * preserve->weight[i] * preserve->gradient[i];
}

static void preserve_sum(Preserve* preserve, Body* body, double h) {
    Membrane* membrane = &body->membrane;
    for (int i = 0; i < body->count; i++)
        preserve->x[i] = to_double4(body->x[i]);
    for (int e = 0; e < membrane->count; e++)
        preserve->thickness[e] = (double)membrane->thickness[e];

    for (preserve->passes = 0; preserve->passes < PASSES_MOST; preserve->passes++) {
        double sum;
        const double c = constraint(membrane, preserve, body->count, &sum);
        if (!(fabs(c) > enough * membrane->volume))
            break;
        move(membrane, preserve, body->count, -c / sum);
    }

    for (int i = 0; i < body->count; i++) {
        const real4 x = to_real4(preserve->x[i]);
        body->v[i] += (x - body->x[i]) / (real)h;
        body->x[i] = x;
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
    free(preserve->x);
    free(preserve->gradient);
    free(preserve->weight);
    free(preserve->thickness);
    *preserve = (Preserve){0};
}
