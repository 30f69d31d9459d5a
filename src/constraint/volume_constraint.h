/// Preservation of the rubber's volume after a step, by one of two rules (body/membrane.h).
///
/// local   h = h0 A0 / A of each element, exactly; no particle moves.
/// global  the thin-shell paper's position-based constraint on the sum,
///
///     C = sum over elements of s h A - h0 A0,  h A = (x4 - c) . (e12 x e13) / 2
///
///         with a virtual vertex x4 = c + h n over the middle c of each element. Particles weigh
///         rho h0 A0 / 6 for each corner, x4 half of the element. One pass moves all of them by
///         -C w dC / sum of w |dC|^2, and passes are repeated until |C| < 1e-12 of the rubber; then
///         h = (x4 - c) . n, and v = (x - x_old) / h. Eq. 27 as printed leaves a fifth of the error
///         in each pass. Only the sum is kept; membrane_volume_ratio measures single elements.
#ifndef BALLOON_CONSTRAINT_VOLUME_CONSTRAINT_H
#define BALLOON_CONSTRAINT_VOLUME_CONSTRAINT_H

#include "body/body.h"

typedef struct VolumeConstraint {
    real4* moved;      ///< [count] positions during the passes [m]; NULL where the rule is local
    real4* gradient;   ///< [count] dC/dx [m^2], then the displacement of a pass [m]
    real* weight;      ///< [count] 1/m' [1/kg]
    double* share;     ///< [elements] membrane_share
    double* thickness; ///< [elements] during the passes [m]
    int passes;        ///< of the last step
    int inverted;      ///< element whose thickness became 0 or negative in the last step, or NONE
} VolumeConstraint;

/// The loops over elements, eight side by side, compiled once for each kind of machine
/// (base/cpu.h).
typedef struct PreserveKernels {
    /// The rubber's volume now; adds to gradient, and to sum what the virtual vertices are of it.
    double (*volume)(const Membrane* membrane, const VolumeConstraint* preserve, const real4* x,
                     double* sum);

    /// Read the thicknesses off, the particles' ways being in gradient: with n the normal before,
    /// n + m after, what x4 rises over the middle is, without what cancels,
    ///
    ///     (x4 - x_a) . (n + m)^ - h = ((e12 + e13)/3 . m - dx_a . (n + m)) / |n + m|
    ///                                 + dx4 (n . (n + m)) / |n + m| + h (cos - 1)
    void (*rise)(const Membrane* membrane, VolumeConstraint* preserve, const real4* x, real lambda);
} PreserveKernels;

extern const PreserveKernels volume_constraint_kernels_baseline;
#ifdef __x86_64__
extern const PreserveKernels volume_constraint_kernels_v3;
#endif

/// Make the workspace for the body's rule.
void volume_constraint_open(VolumeConstraint* preserve, const Body* body);

/// Keep the rubber's volume after a drift of length h.
void volume_constraint_volume(VolumeConstraint* preserve, Body* body, double h);

void volume_constraint_close(VolumeConstraint* preserve);

#endif
