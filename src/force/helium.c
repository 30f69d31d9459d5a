/// Lift as the mass-spring paper has it: an upward acceleration a = base + per_inflation * amount,
/// E = -sum m_i a y_i at a fixed amount, f_i = m_i a in y.
#include "force/force.h"

static bool present(const Body* body) {
    return body->helium.base != 0 || body->helium.per_inflation != 0;
}

static void uniform(const Body* body, Uniform* sum) {
    sum->acceleration[1] += (real)body_helium(body);
}

static double energy(const Body* body) {
    double sum = 0;
    for (int i = 0; i < body->count; i++)
        sum += (double)body->mass[i] * (double)body->x[i][1];
    return -body_helium(body) * sum;
}

const Force force_helium = {
    .name = "helium",
    .about = "lift, m (base + per_inflation amount) in y",
    .present = present,
    .uniform = uniform,
    .energy = energy,
    .external = true,
};
