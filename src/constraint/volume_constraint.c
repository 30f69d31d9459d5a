#include "constraint/volume_constraint.h"

#include <stdlib.h>
#include <string.h>

#include "base/cpu.h"
#include "base/memory.h"
#include "force/material.h"

static const double tolerance = 1e-12; ///< of the rubber's volume [1]
enum { PASSES_MAX = 20 };              ///< two or three are usual

void volume_constraint_open(VolumeConstraint* preserve, const Body* body) {
    *preserve = (VolumeConstraint){.inverted = NONE};
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
    for (int e = membrane->count; e < membrane->eights * LANES; e++)
        preserve->share[e] = 0; // padding up to the next eight
}

static const PreserveKernels* best_kernels(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return &volume_constraint_kernels_v3;
#endif
    return &volume_constraint_kernels_baseline;
}

/// C, its gradient by the particles, and the sum of w |dC|^2.
static double constraint(const Membrane* membrane, VolumeConstraint* preserve, const real4* x,
                         int count, double* sum) {
    memset(preserve->gradient, 0, (size_t)count * sizeof *preserve->gradient);
    *sum = 0;
    const double volume = best_kernels()->volume(membrane, preserve, x, sum);
    for (int i = 0; i < count; i++) {
        const real4 g = preserve->gradient[i];
        *sum += (double)(preserve->weight[i] * dot(g, g));
    }
    return volume - membrane->volume;
}

/// Move all vertices by lambda times weight times gradient, and compute the thickness.
static void move(const Membrane* membrane, VolumeConstraint* preserve, const real4* x, int count,
                 real lambda) {
    real4* restrict way = preserve->gradient;
    for (int i = 0; i < count; i++)
        way[i] *= lambda * preserve->weight[i];
    best_kernels()->rise(membrane, preserve, x, lambda);
    for (int i = 0; i < count; i++)
        preserve->moved[i] += way[i];
}

static void preserve_sum(VolumeConstraint* preserve, Body* body, double h) {
    Membrane* membrane = &body->membrane;
    memset(preserve->moved, 0, (size_t)body->count * sizeof *preserve->moved);
    for (int e = 0; e < membrane->eights * LANES; e++)
        preserve->thickness[e] = (double)membrane->thickness[e];
    for (preserve->passes = 0; preserve->passes < PASSES_MAX; preserve->passes++) {
        double sum;
        const double c = constraint(membrane, preserve, body->x, body->count, &sum);
        if (!(fabs(c) > tolerance * membrane->volume))
            break;
        move(membrane, preserve, body->x, body->count, (real)(-c / sum));
    }
    for (int i = 0; i < body->count; i++) {
        body->v[i] += preserve->moved[i] / (real)h;
        body->x[i] += preserve->moved[i];
    }
    preserve->inverted = NONE;
    for (int e = 0; e < membrane->count; e++) {
        membrane->thickness[e] = (real)preserve->thickness[e];
        if (!(membrane->thickness[e] > 0))
            preserve->inverted = e;
    }
}

void volume_constraint_volume(VolumeConstraint* preserve, Body* body, double h) {
    Membrane* membrane = &body->membrane;
    if (membrane->count == 0)
        return;
    if (membrane->rubber.rule == VOLUME_GLOBAL)
        preserve_sum(preserve, body, h);
    else if (membrane->rubber.material->reads_thickness)
        for (int e = 0; e < membrane->count; e++)
            membrane->thickness[e] = (real)membrane_thickness(membrane, body->x, e);
}

void volume_constraint_close(VolumeConstraint* preserve) {
    free(preserve->moved);
    free(preserve->gradient);
    free(preserve->weight);
    free(preserve->share);
    free(preserve->thickness);
    *preserve = (VolumeConstraint){0};
}
