/// A rubber skin of thin elements: three-prisms, which are the mesh's triangles with a thickness.
///
/// The deformation of an element is constant. With e1, e2 its edges from the first corner and
/// E1, E2 the same at rest, in the element's own plane,
///
///     F = [e1 e2] [E1 E2]^-1      3 x 2, the membrane part of the deformation gradient
///     C = F^T F                   2 x 2
///     energy = h0 A0 W(tr C, det C)                                                  [J]
///
/// W is the material's (force/material.h). Thickness is no direction of its own but a number: what
/// the material makes of it (incompressible rubber: h = h0 A0 / A), or a state that volume
/// preservation keeps (constraint/volume_constraint.h). Bending and transverse shear have no
/// energy. Source: the thin-shell balloon paper, "Three-prism element", with the 3 x 2 gradient.
///
/// A quad is split along its shorter diagonal. Where the diagonals are alike, it is split along
/// both into four elements of half weight, so that a symmetric mesh stays symmetric.
#ifndef BALLOON_BODY_MEMBRANE_H
#define BALLOON_BODY_MEMBRANE_H

#include <stdint.h>

#include "base/vec.h"
#include "mesh/mesh.h"

typedef struct Material Material;

/// How the rubber's volume is kept (constraint/volume_constraint.h).
typedef enum VolumeRule {
    VOLUME_LOCAL,  ///< each element's: h = h0 A0 / A
    VOLUME_GLOBAL, ///< the sum of all, by moving particles and thicknesses; the paper's
    VOLUME_RULES
} VolumeRule;
extern const char* const volume_rule_name[VOLUME_RULES];

/// Capacity for a material's own parameters.
enum { MATERIAL_PARAMETERS_MAX = 4 };

/// What a scene says of a skin's rubber.
typedef struct Rubber {
    const Material* material;
    double young;                              ///< E [Pa]
    double density;                            ///< rho [kg/m^3]
    double parameter[MATERIAL_PARAMETERS_MAX]; ///< the material's own, in its row's order
    VolumeRule rule;
} Rubber;

enum { MEMBRANE_MAX_PARTS = 64 };

typedef struct Membrane {
    Rubber rubber;
    double constant[2]; ///< the material's, from E and its parameters [Pa]
    int count;          ///< elements
    int (*corner)[3];   ///< [count] particles, counter-clockwise seen from outside
    real4* rest;        ///< [count] [E1 E2]^-1 = (r0 r1; 0 r2) in the element's plane [1/m], and in
                        ///< r3 the rest volume h0 A0 of rubber, half of it where two splits overlap
                        ///< [m^3]
    real* first;        ///< [count] h0 [m]
    real* thickness;    ///< [count] h as the material reads it [m]
    double volume;      ///< sum of h0 A0 [m^3]

    // the same, eight elements side by side; what is over has no rubber
    int eights; ///< how many eights there are
    int parts;  ///< equal parts of them, of which none but neighbors share a particle
    uint32_t (
        *lane_corner)[3][LANES]; ///< [eights] particles, in bytes from the start of a real4 array
    real (*lane_rest)[4][LANES]; ///< [eights] r0 … r3
} Membrane;

/// Elements of the mesh at the positions x, which are at rest there.
/// thickness: [mesh->point_count] h0 at the particles [m]; an element takes the mean of its
/// corners.
void membrane_make(Membrane* membrane, const Mesh* mesh, const real4* x, const double* thickness,
                   const Rubber* rubber);

/// Where a part of the eights begins.
static inline int membrane_part(int eights, int parts, int part) {
    return (int)((long)eights * part / parts);
}

/// Add a third of each element's rubber to its corners. mass: [point_count] [kg]
void membrane_add_mass(const Membrane* membrane, double* mass);

/// Area of an element now [m^2].
static inline double membrane_area(const Membrane* membrane, const real4* x, int element) {
    const int* c = membrane->corner[element];
    const double4 a = to_double4(x[c[0]]);
    return dlength(dcross(to_double4(x[c[1]]) - a, to_double4(x[c[2]]) - a)) / 2;
}

/// Share of an element in the skin: 1, or 1/2 where two splits of a quad overlap.
double membrane_share(const Membrane* membrane, int element);

/// Thickness of an element now [m]: a state under the global rule, else h0 A0 / A.
static inline double membrane_thickness(const Membrane* membrane, const real4* x, int element) {
    if (membrane->rubber.rule == VOLUME_GLOBAL)
        return (double)membrane->thickness[element];
    const real4 r = membrane->rest[element];
    const double area_at_rest = 0.5 / ((double)r[0] * (double)r[2]);
    return (double)membrane->first[element] * area_at_rest / membrane_area(membrane, x, element);
}

/// The larger principal stretch of an element [1].
double membrane_stretch(const Membrane* membrane, const real4* x, int element);

/// Rubber now over rubber at rest, summed and of the worst element [1].
typedef struct VolumeRatio {
    double sum;
    double worst; ///< the element's ratio that is farthest from 1
} VolumeRatio;
VolumeRatio membrane_volume_ratio(const Membrane* membrane, const real4* x);

void membrane_free(Membrane* membrane);

#endif
