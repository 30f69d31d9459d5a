#include "solve/residual.h"

#include <string.h>

#include "base/vectors.h"

/// Velocity that does not matter. [of the body's size per second]
static const double speed_floor = 0.01;

double residual_scale(Body* body, double h) {
    double sum = 0;
    for (int k = 0; k < force_count; k++) {
        if (!force_table[k]->present(body))
            continue;
        memset(body->f, 0, (size_t)body->count * sizeof *body->f);
        force_add(force_table[k], body);
        const double size =
            sqrt(vectors()->weighted_squares(body->inverse_mass, body->f, body->count));
        sum += size * size;
    }
    return h * sqrt(sum);
}

double residual_of_step(Body* body, const real4* v_start, double h) {
    const double floor = speed_floor * body->size;
    double mass = 0;
    for (int i = 0; i < body->count; i++)
        mass += (double)body->mass[i];
    const double scale = fmax(residual_scale(body, h), floor * sqrt(mass));
    force_sum(body);
    for (int i = 0; i < body->count; i++)
        body->f[i] = body->mass[i] * (body->v[i] - v_start[i]) - (real)h * body->f[i];
    const double size = sqrt(vectors()->weighted_squares(body->inverse_mass, body->f, body->count));
    return size / scale;
}
