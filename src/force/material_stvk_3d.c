/// St. Venant-Kirchhoff in space, the thin-shell paper's: W = mu (e:e + g^2) + L/2 (tr e + g)^2
/// with Green's strain e = (C - 1)/2 and g = (t^2 - 1)/2 from the thickness t = h/h0, a parameter
/// that the volume constraint sets between steps. mu = E / (2 (1 + nu)), L = E nu / ((1 + nu) (1 -
/// 2 nu)), so nu must be below 1/2. Source: eq. 6 and 9 of the paper.
#include "force/membrane_kernel.inc"

static inline LanesLaw law(const real k[2], lanes t, lanes I, lanes D) {
    (void)D;
    const real mu = k[0], L = k[1];
    const lanes g = (t * t - 1) / 2;
    return (LanesLaw){.w1 = mu * (I - 1) / 2 + L * ((I - 2) / 2 + g) / 2,
                      .w2 = -mu / 2 + (lanes){0},
                      .w11 = mu / 2 + L / 4 + (lanes){0}};
}

#ifdef KERNEL_V3
const ElementLoops stvk_3d_v3 = {add_elements, assemble_elements, bound_elements};
#else

static double energy(const double k[2], double t, double I, double D) {
    const double g = (t * t - 1) / 2, trace = (I - 2) / 2 + g;
    const double square = (I * I - 2 * D - 2 * I + 2) / 4 + g * g;
    return k[0] * square + k[1] / 2 * trace * trace;
}

/// The default is the paper's.
static const Parameter parameters[] = {
    {"poisson", "1", -1, 0.5, .min_open = true, .max_open = true, .default_value = 0.45,
     .about = "Poisson's ratio"},
};

static void constants(const Rubber* rubber, double k[2]) {
    const double nu = rubber->parameter[0];
    k[0] = rubber->young / (2 * (1 + nu));
    k[1] = rubber->young * nu / ((1 + nu) * (1 - 2 * nu));
}

const Material material_stvk_3d = {
    .name = "stvk-3d",
    .about = "St. Venant-Kirchhoff with the thickness as a parameter, the thin-shell paper's",
    .reads_thickness = true,
    .parameters = parameters,
    .parameter_count = sizeof parameters / sizeof *parameters,
    .constants = constants,
    .energy = energy,
    .loops = {add_elements, assemble_elements, bound_elements},
    .v3 = V3_LOOPS(stvk_3d_v3),
};
#endif
