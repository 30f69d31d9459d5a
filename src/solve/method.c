#include "solve/method.h"

#include <stdio.h>

#include "base/fault.h"
#include "base/table.h"
#include "force/damping.h"

const char* const step_start_name[STEP_STARTS] = {"inertia", "rest"};

const Method* const method_table[] = {&method_euler, &method_newton, &method_forward, &method_xpbd,
                                      &method_projective};
const int method_count = sizeof method_table / sizeof *method_table;

const Method* method_find(const char* name) {
    return table_find(method_table, method_count, name);
}

/// Whether the method supports this force.
static bool takes(const Method* method, const Force* force) {
    if (!method->takes)
        return true;
    const ForceUse* use = method->takes;
    while (use->force && use->force != force)
        use++;
    return use->force != NULL;
}

const char* method_refuses(const Method* method, const Body* body) {
    static char sentence[FORCES_MAX][64]; // the same for every method
    for (int k = 0; k < force_count; k++) {
        if (!force_table[k]->present(body) || takes(method, force_table[k]))
            continue;
        ASSERT(k < FORCES_MAX, "there is a sentence for each force");
        snprintf(sentence[k], sizeof sentence[k], "takes no force '%s'", force_table[k]->name);
        return sentence[k];
    }
    return method->refuses ? method->refuses(body) : NULL;
}

double method_limit(const Method* method, double w2, double gamma) {
    return method->implicit ? INFINITY : method->limit(w2, gamma);
}

/// Damping rates c/m over the particles that move [1/s].
static void damping_rates(const Body* body, double* min, double* max) {
    const double coefficient = body->force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT];
    const double rate = body->force_parameter[FORCE_DAMPING][DAMPING_RATE];
    real light = 0, heavy = (real)INFINITY; // the largest and the smallest 1/m
    for (int i = 0; coefficient != 0 && i < body->count; i++) {
        const real w = body->inverse_mass[i];
        light = w > light ? w : light;
        heavy = w > 0 && w < heavy ? w : heavy;
    }
    *max = coefficient * (double)light + rate;
    *min = light > 0 ? coefficient * (double)heavy + rate : *max;
}

double method_bound(const Method* method, const Body* body) {
    if (method->implicit)
        return INFINITY;
    double w2 = 0;
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->bound && force_table[k]->present(body))
            w2 += force_table[k]->bound(body);
    w2 += body->joined_w2;
    double min, max;
    damping_rates(body, &min, &max);
    return fmin(method->limit(w2, min), method->limit(w2, max));
}
