#include "force/force.h"

#include <assert.h>
#include <string.h>

#include "base/crew.h"
#include "force/kernel.h"
#include "force/sweep.h"

const Force* const force_table[FORCES] = {
    [FORCE_GRAVITY] = &force_gravity,   [FORCE_HELIUM] = &force_helium,
    [FORCE_SPRINGS] = &force_springs,   [FORCE_TORSION] = &force_torsion,
    [FORCE_MEMBRANE] = &force_membrane, [FORCE_INFLATION] = &force_inflation,
    [FORCE_LIFT] = &force_lift,         [FORCE_STRINGS] = &force_strings,
    [FORCE_DAMPING] = &force_damping,
};
const int force_count = FORCES;
static_assert((int)FORCES <= (int)FORCES_MAX, "Body.force_parameter has a row for each force");

/// Arguments of the tasks of a pass over the particles.
typedef struct Pass {
    Body* body;
    const Uniform* uniform;
    double h;
} Pass;

static void uniform_part(void* self, int part) {
    const Pass* pass = self;
    Body* body = pass->body;
    const real4* gradient = pass->uniform->pressure != 0 ? body->inflation.gradient : NULL;
    const int from = part * PART_PARTICLES, end = from + PART_PARTICLES;
    kernels()->uniform(pass->uniform, from, end < body->count ? end : (body->count + 1) / 2 * 2,
                       gradient, body->mass, body->inverse_mass, (real)pass->h, body->v, body->f);
}

/// body->f += the uniform forces (uniform.h); v' = v + h f / m where h is not 0.
static void add_uniform(Body* body, const Uniform* uniform, double h) {
    crew_run(uniform_part, &(Pass){body, uniform, h}, parts_of(body->count, PART_PARTICLES));
}

static void take(Body* body, SweepSums sums) {
    body->inflation.area = sums.area;
    body->inflation.volume = sums.volume;
}

void force_push(Body* body, double h) {
    bool here[FORCES];
    unsigned flags = 0;
    for (int k = 0; k < force_count; k++) {
        here[k] = force_table[k]->present(body);
        if (here[k] && force_table[k]->sweep)
            flags |= force_table[k]->sweep(body);
    }
    if (flags)
        flags |= SWEEP_CLEAR;
    else
        memset(body->f, 0, (size_t)body->count * sizeof *body->f);
    take(body, sweep(body, flags));

    Uniform uniform = {.pressure = 0};
    for (int k = 0; k < force_count; k++) {
        if (here[k] && force_table[k]->add)
            force_table[k]->add(body);
        if (here[k] && force_table[k]->uniform)
            force_table[k]->uniform(body, &uniform);
    }
    add_uniform(body, &uniform, h);
}

void force_sum(Body* body) {
    force_push(body, 0);
}

void force_add(const Force* force, Body* body) {
    if (force->sweep)
        take(body, sweep(body, force->sweep(body)));
    if (force->add)
        force->add(body);
    if (force->uniform) {
        Uniform uniform = {.pressure = 0};
        force->uniform(body, &uniform);
        add_uniform(body, &uniform, 0);
    }
}
