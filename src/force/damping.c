/// Drag dissipates energy and has no potential.
#include "force/damping.h"

#include <math.h>

static const Parameter parameters[] = {
    [DAMPING_COEFFICIENT] = {"coefficient", "kg/s", 0, INFINITY, .per_particle = true,
                             .about = "drag per velocity of each particle"},
    [DAMPING_RATE] = {"rate", "1/s", 0, INFINITY,
                      .about = "the same per mass; not with `coefficient`"},
};

static bool present(const Body* body) {
    const double* parameter = body->force_parameter[FORCE_DAMPING];
    return parameter[DAMPING_COEFFICIENT] != 0 || parameter[DAMPING_RATE] != 0;
}

static void uniform(const Body* body, Uniform* sum) {
    sum->drag += body->force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT];
    sum->rate += body->force_parameter[FORCE_DAMPING][DAMPING_RATE];
}

const Force force_damping = {
    .name = "damping",
    .about = "drag of the air, -(coefficient + rate m) v",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .exclusive = true,
    .present = present,
    .uniform = uniform,
    .external = true,
};
