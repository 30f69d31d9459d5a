/// Drag of the air: f_i = -(c + rate m_i) v_i. It takes energy out and has none of its own.
#include "force/force.h"

static bool present(const Body* body) {
    return body->damping.coefficient != 0 || body->damping.rate != 0;
}

static void add(Body* body) {
    const real c = (real)body->damping.coefficient, rate = (real)body->damping.rate;
    for (int i = 0; i < body->count; i++)
        body->f[i] -= (c + rate * body->mass[i]) * body->v[i];
}

const Force force_damping = {
    .name = "damping",
    .about = "drag, -(coefficient + rate m) v",
    .present = present,
    .add = add,
};
