#include "solve/method.h"

#include "base/table.h"
#include "force/force.h"

const char* const step_start_name[STEP_STARTS] = {"inertia", "rest"};

const Method* const method_table[] = {&method_euler, &method_newton};
const int method_count = sizeof method_table / sizeof *method_table;

const Method* method_find(const char* name) {
    return table_find(method_table, method_count, name);
}

const char* method_names(void) {
    static char names[256];
    return table_names(method_table, method_count, names, sizeof names);
}

/// Largest damping rate c/m over the particles [1/s].
static double damping_rate(const Body* body) {
    double rate = 0;
    for (int i = 0; i < body->count; i++)
        rate = fmax(rate, body_drag(body, i) * (double)body->inverse_mass[i]);
    return rate;
}

double method_bound(const Method* method, const Body* body) {
    if (method->limit(INFINITY, INFINITY) == INFINITY)
        return INFINITY;
    double w2 = 0;
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->bound && force_table[k]->present(body))
            w2 += force_table[k]->bound(body);
    return method->limit(w2, damping_rate(body));
}
