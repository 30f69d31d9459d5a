/// Drag of the air: f_i = -(c + rate m_i) v_i. It takes energy out and has none of its own.
#include "force/force.h"

static bool present(const Body* body) {
    return body->damping.coefficient != 0 || body->damping.rate != 0;
}

static void uniform(const Body* body, Uniform* sum) {
    sum->drag += body->damping.coefficient;
    sum->rate += body->damping.rate;
}

const Force force_damping = {
    .name = "damping",
    .about = "drag, -(coefficient + rate m) v",
    .present = present,
    .uniform = uniform,
    .external = true,
};
