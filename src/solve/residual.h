/// How well a step solves backward Euler's equation, R = M (v' - v) - h f(x + h v', v') = 0.
///
///     residual = |R|_(1/M) / scale,   scale = h sqrt(sum of |f_k|^2_(1/M) over the forces f_k)
///
/// The scale does not vanish where the forces balance. Where there are none, a velocity of 1/100 of
/// the body's size per second is one that does not matter, and the least scale.
#ifndef BALLOON_SOLVE_RESIDUAL_H
#define BALLOON_SOLVE_RESIDUAL_H

#include "force/force.h"

/// The scale at the body's present positions and velocities; overwrites body->f.
double residual_scale(Body* body, double h);

/// Relative residual [1] of the step from v_start to the body's present positions and velocities,
/// NaN or infinite where these are; overwrites body->f.
double residual_of_step(Body* body, const real4* v_start, double h);

#endif
