/// Neo-Hookean rubber, incompressible: W = mu/2 (I + 1/D - 3), mu = E/3. The simplest law that has
/// the pressure peak of a child's balloon; h = h0 A0/A. Source: R. W. Ogden, Non-linear elastic
/// deformations, 1984.
#include "force/material.h"
#include "force/membrane_kernel.inc"

static inline Law law(const real k[2], real t, real I, real D) {
    (void)t, (void)I;
    const real mu = k[0], inverse = 1 / D;
    return (Law){
        .w1 = mu / 2, .w2 = -mu / 2 * inverse * inverse, .w22 = mu * inverse * inverse * inverse};
}

static double energy(const double k[2], double t, double I, double D) {
    (void)t;
    return k[0] / 2 * (I + 1 / D - 3);
}

static void constants(const Rubber* rubber, double k[2]) {
    k[0] = rubber->young / 3;
    k[1] = 0;
}

const Material material_neo_hookean = {
    .name = "neo-hookean",
    .about = "W = mu/2 (I + 1/D - 3), incompressible rubber",
    .incompressible = true,
    .poisson_most = 0.5,
    .constants = constants,
    .energy = energy,
    .add = add_elements,
    .assemble = assemble_elements,
    .bound = bound_elements,
};
