#include "body/body.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/crew.h"
#include "base/memory.h"
#include "base/vectors.h"
#include "mesh/measure.h"

void body_make(Body* body, const Mesh* mesh, const Placement* placement, double mass) {
    const int count = mesh->point_count;
    *body = (Body){
        .mesh = mesh,
        .count = count,
        .scale = placement->scale,
        .x = new_array(real4, count),
        .v = new_array(real4, count),
        .f = new_array(real4, count),
        .mass = new_array(real, count),
        .inverse_mass = new_array(real, count),
    };

    const double angle = placement->rotation * (PI / 180);
    const double c = cos(angle), s = sin(angle);
    double4 low = {INFINITY, INFINITY, INFINITY, 0}, high = -low;
    for (int i = 0; i < count; i++) {
        const double4 p = placement->scale * (mesh->point[i] - placement->center);
        const double4 turned = {c * p[0] + s * p[2], p[1], c * p[2] - s * p[0], 0};
        const double4 x = placement->position + turned;
        body->x[i] = to_real4(x);
        body->mass[i] = (real)mass;
        body->inverse_mass[i] = (real)(1 / mass);
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], x[k]);
            high[k] = fmax(high[k], x[k]);
        }
    }
    const double4 side = high - low;
    body->size = fmax(side[0], fmax(side[1], side[2]));
}

/// Largest (S_i/m_i + S_j/m_j): by Gershgorin on the edge form of K, whose eigenvalues are those of
/// M^-1 K. Deformed springs are softer across than along, so it holds in every state.
static double springs_bound(const Body* body) {
    const Springs* springs = &body->springs;
    double* sum = new_array(double, body->count);
    for (int s = 0; s < springs->count; s++)
        for (int k = 0; k < 2; k++) {
            const int i = springs->end[s][k];
            sum[i] += (double)springs->stiffness[s] * (double)body->inverse_mass[i];
        }

    double bound = 0;
    for (int s = 0; s < springs->count; s++)
        bound = fmax(bound, sum[springs->end[s][0]] + sum[springs->end[s][1]]);
    free(sum);
    return bound;
}

void body_slice(Body* body) {
    slices_free(&body->slices);
    slices_make(&body->slices, body->count, body->mesh,
                body->springs.count ? &body->springs : NULL);
}

void body_add_springs(Body* body, const double stiffness[SPRING_KINDS], SpringLaw law) {
    Springs* springs = &body->springs;
    bool wanted[SPRING_KINDS];
    for (int kind = 0; kind < SPRING_KINDS; kind++)
        wanted[kind] = stiffness[kind] > 0;
    springs->law = law;
    springs_find(body->mesh, wanted, springs);

    springs->stiffness = new_array(real, springs->count);
    springs->rest = new_array(real, springs->count);
    springs->active = new_array(real, springs->count);
    for (int kind = 0; kind < SPRING_KINDS; kind++)
        for (int s = springs->from[kind]; s < springs->from[kind + 1]; s++) {
            const int* end = springs->end[s];
            springs->rest[s] = length(body->x[end[0]] - body->x[end[1]]);
            springs->stiffness[s] = springs->active[s] = (real)stiffness[kind];
        }
    springs->bound = springs_bound(body);
    body_slice(body);
}

/// Each path's bend has a gradient of at most 1/a at p, 1/b at q and 1/a + 1/b at m, a and b the
/// lengths of its two edges; row sums of M^-1 K over the paths bound its eigenvalues.
static double torsion_bound(const Body* body) {
    const Torsion* torsion = &body->torsion;
    double* sum = new_array(double, body->count);
    for (int t = 0; t < torsion->count; t++) {
        const int* path = torsion->path[t];
        const double a = (double)length(body->x[path[0]] - body->x[path[1]]);
        const double b = (double)length(body->x[path[2]] - body->x[path[1]]);
        const double slope[3] = {1 / a, 1 / a + 1 / b, 1 / b};
        for (int k = 0; k < 3; k++)
            sum[path[k]] += slope[k] * (slope[0] + slope[1] + slope[2]);
    }

    double bound = 0;
    for (int i = 0; i < body->count; i++)
        bound = fmax(bound, (double)torsion->stiffness * sum[i] * (double)body->inverse_mass[i]);
    free(sum);
    return bound;
}

void body_add_torsion(Body* body, double stiffness) {
    Torsion* torsion = &body->torsion;
    torsion_find(body->mesh, torsion);
    torsion->stiffness = (real)stiffness;
    torsion->rest = new_array(real, torsion->count);
    for (int t = 0; t < torsion->count; t++) {
        const int* path = torsion->path[t];
        const real4 u = body->x[path[0]] - body->x[path[1]];
        const real4 w = body->x[path[2]] - body->x[path[1]];
        torsion->rest[t] = length(u / length(u) + w / length(w));
    }
    torsion->bound = torsion_bound(body);
}

void body_hold_rim(Body* body) {
    for (int e = 0; e < body->mesh->edge_count; e++)
        if (body->mesh->edge_face[e][1] == NONE)
            for (int k = 0; k < 2; k++)
                body->inverse_mass[body->mesh->edge[e][k]] = 0;
}

int body_hold(Body* body, const double center[3], double radius) {
    int count = 0;
    for (int i = 0; i < body->count; i++)
        if (body_is_near(body, i, center, radius)) {
            body->inverse_mass[i] = 0;
            count++;
        }
    return count;
}

void body_add_membrane(Body* body, const double* thickness, const Rubber* rubber) {
    membrane_make(&body->membrane, body->mesh, body->x, thickness, rubber);

    double* mass = new_array(double, body->count);
    membrane_add_mass(&body->membrane, mass);
    for (int i = 0; i < body->count; i++) {
        body->mass[i] = (real)mass[i];
        if (body->inverse_mass[i] > 0)
            body->inverse_mass[i] = (real)(1 / mass[i]);
    }
    free(mass);
}

void body_inflate(Body* body, const Inflation* inflation) {
    body->inflation = *inflation;
    body->inflation.first_volume = measure_volume(body->mesh, body->x);
    body->inflation.volume = body->inflation.first_volume;
    body->inflation.gradient = new_array(real4, body->count);
    if (!body->slices.count)
        body_slice(body);
}

void body_tie(Body* body, int particle, const double anchor[3], double stiffness, double slack) {
    array_reserve(body->string, body->string_count, body->string_capacity);
    const real4 end = to_real4((double4){anchor[0], anchor[1], anchor[2], 0});
    const real distance = length(body->x[particle] - end), free_length = (real)slack * distance;
    body->string[body->string_count++] = (String){
        .particle = particle,
        .anchor = end,
        .stiffness = (real)stiffness,
        .free_length = free_length,
        .first_stretch = real_max(distance - free_length, 0),
    };
}

static void push(real4* restrict v, const real4* restrict f, const real* restrict inverse_mass,
                 int count, real h) {
    for (int i = 0; i < count; i++)
        v[i] += (h * inverse_mass[i]) * f[i];
}

void body_push(Body* body, double h) {
    push(body->v, body->f, body->inverse_mass, body->count, (real)h);
}

/// Arguments of the tasks of a drift.
typedef struct Drift {
    Body* body;
    real h;
} Drift;

static void drift_part(void* self, int part) {
    const Drift* d = self;
    const int from = part * PART_PARTICLES, left = d->body->count - from;
    vectors()->add(&d->body->x[from], d->h, &d->body->v[from],
                   left < PART_PARTICLES ? left : PART_PARTICLES);
}

void body_drift(Body* body, double h) {
    crew_run(drift_part, &(Drift){body, (real)h}, parts_of(body->count, PART_PARTICLES));
}

void body_free(Body* body) {
    springs_free(&body->springs);
    slices_free(&body->slices);
    torsion_free(&body->torsion);
    membrane_free(&body->membrane);
    free(body->inflation.gradient);
    free(body->string);
    free(body->x);
    free(body->v);
    free(body->f);
    free(body->mass);
    free(body->inverse_mass);
    *body = (Body){0};
}
