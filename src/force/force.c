#include "force/force.h"

#include <string.h>

const Force* const force_table[] = {
    &force_gravity,   &force_helium, &force_springs, &force_torsion, &force_membrane,
    &force_inflation, &force_lift,   &force_strings, &force_damping,
};
const int force_count = sizeof force_table / sizeof *force_table;

void force_sum(Body* body) {
    memset(body->f, 0, (size_t)body->count * sizeof *body->f);
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->present(body))
            force_table[k]->add(body);
}
