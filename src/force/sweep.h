/// One pass over the particles' neighbors (body/slices.h), eight particles at a time, computes the
/// sums that springs and pressure need:
///
///     springs    f_a += sum over the neighbors of the pull along d              (force/springs.c)
///     gradient   dV/da = 1/12 sum over the ring of (c_k + b_k) x (b_(k+1) - b_k)
///     area       A = sum over particles and rings of |c_k x (b_(k+1) - b_k)| / 8, / 6 of triangles
///     volume     V = 1/3 sum over particles of a . dV/da, from an origin on the skin
///
/// with b and c as seen from a. That is mesh/measure.h's gradient, corner by corner: with D and N
/// there, D + N_a = c x (d - b) + b x d. An open skin's is D / 8 of quads and N / 6 of triangles.
#ifndef BALLOON_FORCE_SWEEP_H
#define BALLOON_FORCE_SWEEP_H

#include "body/body.h"

enum {
    SWEEP_SPRINGS = 1,  ///< added to body->f
    SWEEP_GRADIENT = 2, ///< into body->inflation.gradient
    SWEEP_AREA = 4,     ///< with the gradient
    SWEEP_VOLUME = 8,   ///< with the gradient
    SWEEP_CLEAR = 16    ///< set body->f instead of adding to it
};

/// Sums over the particles, 0 if not requested.
typedef struct SweepSums {
    double area;   ///< [m^2]
    double volume; ///< [m^3]
} SweepSums;

/// flags: the sums to compute, SWEEP_SPRINGS | ….
SweepSums sweep(const Body* body, unsigned flags);

/// Bounds for the stiffness of a pressure: row sums of |d2V/dx2| (Gershgorin), and squared norms of
/// dA/dx and dV/dx, divided by the masses. Each entry of d2V/dx2 is at most the length of an edge
/// or a diagonal, because the gradients are cross products of these.
typedef struct SweepBounds {
    double second;  ///< largest over particles a of sum over corners k |d2V / da dx_k| / m_a [m/kg]
    double area2;   ///< sum of |dA/da|^2 / m_a, its bound [m^2/kg]
    double volume2; ///< sum of |dV/da|^2 / m_a [m^4/kg]
    SweepSums sums; ///< area and volume
} SweepBounds;

SweepBounds sweep_bounds(const Body* body);

#endif
