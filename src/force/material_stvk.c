/// St. Venant-Kirchhoff in plane stress: W = mu e:e + L/2 (tr e)^2 with Green's strain
/// e = (C - 1)/2, mu = E / (2 (1 + nu)), L = E nu / (1 - nu^2). Valid for small strain: the
/// pressure of a balloon has no maximum, and the law softens in compression.
#include "force/membrane_kernel.inc"

static inline LanesLaw law(const real k[2], lanes t, lanes I, lanes D) {
    (void)t, (void)D;
    const real mu = k[0], L = k[1];
    return (LanesLaw){.w1 = mu * (I - 1) / 2 + L * (I - 2) / 4,
                      .w2 = -mu / 2 + (lanes){0},
                      .w11 = mu / 2 + L / 4 + (lanes){0}};
}

#ifdef KERNEL_V3
const ElementLoops stvk_v3 = {add_elements, assemble_elements, bound_elements};
#else

static double energy(const double k[2], double t, double I, double D) {
    (void)t;
    const double trace = (I - 2) / 2, square = (I * I - 2 * D - 2 * I + 2) / 4;
    return k[0] * square + k[1] / 2 * trace * trace;
}

static const Parameter parameters[] = {
    {"poisson", "1", -1, 0.5, .min_open = true, .default_value = 0.5, .about = "Poisson's ratio"},
};

static void constants(const Rubber* rubber, double k[2]) {
    const double nu = rubber->parameter[0];
    k[0] = rubber->young / (2 * (1 + nu));
    k[1] = rubber->young * nu / (1 - nu * nu);
}

const Material material_stvk = {
    .name = "stvk",
    .about = "St. Venant-Kirchhoff in plane stress",
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .constants = constants,
    .energy = energy,
    .loops = {add_elements, assemble_elements, bound_elements},
    .v3 = V3_LOOPS(stvk_v3),
};
#endif
