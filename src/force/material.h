/// Materials of rubber skins: a table, one file and one row each.
///
/// A material is its energy per rest volume W(I, D) of a thin sheet, I = tr C and D = det C, the
/// squared area ratio (body/membrane.h). Normal to the sheet the stress is zero, or the thickness
/// is prescribed (stvk-3d). With w1 = dW/dI and w2 = dW/dD
///
///     second Piola-Kirchhoff stress   S = 2 (w1 1 + w2 adj C)                        [Pa]
///     force on an edge                -h0 A0 F S [E1 E2]^-T                          [N]
///
/// so each material is defined by the derivatives of W, from which its file compiles the loops over
/// elements (force/membrane_kernel.inc).
#ifndef BALLOON_FORCE_MATERIAL_H
#define BALLOON_FORCE_MATERIAL_H

#include "base/fault.h"
#include "force/force.h"

/// The loops over elements in a step (membrane_lanes.inc, membrane_kernel.inc). Elements are stored
/// in groups of eight (body/membrane.h).
typedef struct ElementLoops {
    /// f += force of the elements on their corners, groups from … to - 1. [N]
    void (*add)(const Membrane* membrane, int from, int to, const real4* x, real4* f);

    /// Force.assemble of every element, factor times K; with `project`, its positive semidefinite
    /// part.
    void (*assemble)(const Membrane* membrane, const real4* x, real factor, bool project,
                     const int* block_at, Block* value);

    /// Upper bound on the squared frequencies of the same elements [1/s^2].
    double (*bound)(const Membrane* membrane, int from, int to, const real4* x);
} ElementLoops;

#ifdef __x86_64__
extern const ElementLoops neo_hookean_v3, mooney_rivlin_v3, stvk_v3, stvk_3d_v3;
#define V3_LOOPS(loops) &loops
#else
#define V3_LOOPS(loops) NULL
#endif

struct Material {
    const char* name;
    const char* about;
    bool reads_thickness; ///< W depends on the thickness, which the volume constraint sets

    /// Parameters beside E and the density; their values are in Rubber.parameter.
    const Parameter* parameters;
    int parameter_count; ///< at most MATERIAL_PARAMETERS_MAX

    /// The law's constants from E and its parameters. [Pa]
    void (*constants)(const Rubber* rubber, double constant[2]);

    /// Energy per rest volume; t = h/h0 is ignored without reads_thickness. [J/m^3]
    double (*energy)(const double constant[2], double t, double I, double D);

    ElementLoops loops;     ///< for every machine
    const ElementLoops* v3; ///< compiled for x86-64-v3
};

extern const Material material_neo_hookean, material_mooney_rivlin, material_stvk, material_stvk_3d;

extern const Material* const material_table[];
extern const int material_count;

/// The loops for this machine.
const ElementLoops* material_loops(const Material* material);

/// Give a body a skin of rubber (body_add_membrane) with the material's constants.
void material_add(Body* body, const double* thickness, const Rubber* rubber);

/// Row by name, or NULL.
const Material* material_find(const char* name);

/// The material's parameter of this name, or NULL.
const Parameter* material_parameter(const Material* material, const char* name);

/// The rubber's value of the parameter of this name; `otherwise` if its material has none.
double rubber_parameter(const Rubber* rubber, const char* name, double otherwise);

#endif
