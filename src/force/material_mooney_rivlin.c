/// Mooney-Rivlin rubber, incompressible: W = C1 (I + 1/D - 3) + C2 (D + I/D - 3), E = 6 (C1 + C2).
/// It stiffens at large stretch; above C2/C1 = 0.2144 the pressure of a balloon has no maximum.
/// Source: R. W. Ogden, Non-linear elastic deformations, 1984.
#include "force/membrane_kernel.inc"

static inline LanesLaw law(const real k[2], lanes t, lanes I, lanes D) {
    (void)t;
    const real c1 = k[0], c2 = k[1];
    const lanes inverse = 1 / D, inverse2 = inverse * inverse;
    return (LanesLaw){.w1 = c1 + c2 * inverse,
                      .w2 = c2 - (c1 + c2 * I) * inverse2,
                      .w12 = -c2 * inverse2,
                      .w22 = 2 * (c1 + c2 * I) * inverse2 * inverse};
}

#ifdef KERNEL_V3
const ElementLoops mooney_rivlin_v3 = {add_elements, assemble_elements, bound_elements};
#else

static double energy(const double k[2], double t, double I, double D) {
    (void)t;
    return k[0] * (I + 1 / D - 3) + k[1] * (D + I / D - 3);
}

static const Parameter parameters[] = {
    {"mooney", "1", 0, INFINITY, .about = "C2/C1"},
    {"poisson", "1", 0.5, 0.5, .default_value = 0.5, .about = "Poisson's ratio: incompressible"},
};

static void constants(const Rubber* rubber, double k[2]) {
    const double ratio = rubber->parameter[0];
    k[0] = rubber->young / (6 * (1 + ratio));
    k[1] = ratio * k[0];
}

const Material material_mooney_rivlin = {
    .name = "mooney-rivlin",
    .about = "W = C1 (I + 1/D - 3) + C2 (D + I/D - 3), incompressible rubber",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .constants = constants,
    .energy = energy,
    .loops = {add_elements, assemble_elements, bound_elements},
    .v3 = V3_LOOPS(mooney_rivlin_v3),
};
#endif
