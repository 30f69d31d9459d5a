/// One pass over the particles' neighbourhoods (body/slices.h) finds what springs and pressure need
/// of them, eight particles at a time:
///
///     springs    f_a += sum over the neighbours of the pull along d              (force/springs.c)
///     gradient   dV/da = 1/12 sum over the ring of (c_k + b_k) x (b_(k+1) - b_k)
///     area       A = sum over particles and rings of |c_k x (b_(k+1) - b_k)| / 8, / 6 of triangles
///     volume     V = 1/3 sum over particles of a . dV/da, from an origin on the skin
///
/// with b and c as seen from a. That is mesh/measure.h's gradient, corner by corner: with D and N
/// there, D + N_a = c x (d - b) + b x d. Skins that are no closed rings take measure.h's own.
#ifndef BALLOON_FORCE_SWEEP_H
#define BALLOON_FORCE_SWEEP_H

#include "body/body.h"

enum {
    SWEEP_SPRINGS = 1,  ///< into body->f
    SWEEP_GRADIENT = 2, ///< into body->inflation.gradient
    SWEEP_AREA = 4,     ///< into body->inflation.area; with the gradient
    SWEEP_VOLUME = 8    ///< into body->inflation.volume; with the gradient
};

void sweep(Body* body, unsigned wanted);

#endif
