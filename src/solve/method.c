#include "solve/method.h"

#include <string.h>

#include "force/force.h"

const Method* const method_table[] = {&method_euler};
const int method_count = sizeof method_table / sizeof *method_table;

const Method* method_find(const char* name) {
    for (int k = 0; k < method_count; k++)
        if (strcmp(method_table[k]->name, name) == 0)
            return method_table[k];
    return NULL;
}

const char* method_names(void) {
    static char names[256];
    names[0] = 0;
    for (int k = 0; k < method_count; k++) {
        strncat(names, k ? ", " : "", sizeof names - strlen(names) - 1);
        strncat(names, method_table[k]->name, sizeof names - strlen(names) - 1);
    }
    return names;
}

/// Largest damping rate c/m over the particles [1/s].
static double damping_rate(const Body* body) {
    double rate = 0;
    for (int i = 0; i < body->count; i++)
        rate = fmax(rate, body_drag(body, i) * (double)body->inverse_mass[i]);
    return rate;
}

double method_bound(const Method* method, const Body* body) {
    double w2 = 0;
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->bound && force_table[k]->present(body))
            w2 += force_table[k]->bound(body);
    return method->limit(w2, damping_rate(body));
}
