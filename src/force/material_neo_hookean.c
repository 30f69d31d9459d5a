/// Neo-Hookean rubber, incompressible: W = mu/2 (I + 1/D - 3), mu = E/3, h = h0 A0/A. The simplest
/// law with the pressure maximum of a toy balloon. Source: R. W. Ogden, Non-linear elastic
/// deformations, 1984.
#include "force/membrane_kernel.inc"

static inline LanesLaw law(const real k[2], lanes t, lanes I, lanes D) {
    (void)t, (void)I;
    const real mu = k[0];
    const lanes inverse = 1 / D;
    return (LanesLaw){.w1 = mu / 2 + (lanes){0},
                      .w2 = -mu / 2 * inverse * inverse,
                      .w22 = mu * inverse * inverse * inverse};
}

#ifdef KERNEL_V3
const ElementLoops neo_hookean_v3 = {add_elements, assemble_elements, bound_elements};
#else

static double energy(const double k[2], double t, double I, double D) {
    (void)t;
    return k[0] / 2 * (I + 1 / D - 3);
}

static const Parameter parameters[] = {
    {"poisson", "1", 0.5, 0.5, .default_value = 0.5, .about = "Poisson's ratio: incompressible"},
};

static void constants(const Rubber* rubber, double k[2]) {
    k[0] = rubber->young / 3;
    k[1] = 0;
}

const Material material_neo_hookean = {
    .name = "neo-hookean",
    .about = "W = mu/2 (I + 1/D - 3), incompressible rubber",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .constants = constants,
    .energy = energy,
    .loops = {add_elements, assemble_elements, bound_elements},
    .v3 = V3_LOOPS(neo_hookean_v3),
};
#endif
