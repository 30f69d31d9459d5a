/// E = -sum m_i a y_i at a fixed amount, f_i = m_i a in y.
#include "force/helium.h"

#include <math.h>

static const Parameter parameters[] = {
    [HELIUM_BASE] = {"base", "m/s^2", -INFINITY, INFINITY, .about = "upward acceleration"},
    [HELIUM_PER_INFLATION] = {"per_inflation", "m/s^2 per unit of amount", -INFINITY, INFINITY,
                              .about = "upward acceleration per unit of inflation.amount"},
};

static bool present(const Body* body) {
    const double* parameter = body->force_parameter[FORCE_HELIUM];
    return parameter[HELIUM_BASE] != 0 || parameter[HELIUM_PER_INFLATION] != 0;
}

static void uniform(const Body* body, Uniform* sum) {
    sum->acceleration[1] += (real)helium_acceleration(body);
}

static double energy(const Body* body) {
    double sum = 0;
    for (int i = 0; i < body->count; i++)
        sum += (double)body->mass[i] * (double)body->x[i][1];
    return -helium_acceleration(body) * sum;
}

const Force force_helium = {
    .name = "helium",
    .about = "lift, m (base + per_inflation amount) in y",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .present = present,
    .uniform = uniform,
    .energy = energy,
    .external = true,
};
