/// Weight: E = sum m_i g y_i, f_i = -m_i g in y.
#include "force/force.h"

static bool present(const Body* body) {
    return body->gravity != 0;
}

static void uniform(const Body* body, Uniform* sum) {
    sum->acceleration[1] -= (real)body->gravity;
}

static double energy(const Body* body) {
    double sum = 0;
    for (int i = 0; i < body->count; i++)
        sum += (double)body->mass[i] * (double)body->x[i][1];
    return body->gravity * sum;
}

const Force force_gravity = {
    .name = "gravity",
    .about = "weight, -m g in y",
    .present = present,
    .uniform = uniform,
    .energy = energy,
    .external = true,
};
