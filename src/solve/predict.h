/// What the methods of constraints share: a step without springs, strings and the gas's pressure.
///
///     u0 = h m v / (m + h c)            where it would go by itself, c the drag
///     u  = u0 + h^2 f(x + u0) / (m + h c)
///
/// f are the forces that are no constraints of these methods: weight, helium, lift, and the
/// pressure of inflation by area or of a constant one. A gas pushes along dV/dx at x + u0 too; how
/// hard is the method's to find. At rest u0 = 0, so that equilibrium is that of the forces,
/// whatever the step. What springs add is u += h^2 f / (m + h c): that is backward Euler with its
/// drag.
#ifndef BALLOON_SOLVE_PREDICT_H
#define BALLOON_SOLVE_PREDICT_H

#include "solve/method.h"

typedef struct Predict {
    real4* u;     ///< [count] displacement of the step [m]
    real4* ahead; ///< [count] x + u0 [m], then the method's
    real* weight; ///< [count] 1 / (m + h c), 0 where held [1/kg]
} Predict;

/// The forces that the methods of constraints take.
extern const ForceUse predict_forces[];

void predict_open(Predict* predict, const Body* body);

/// Fill u and weight; of a gas, also inflation.gradient.
void predict_begin(Predict* predict, Body* body, double h);

/// Volume of the skin at x + u [m^3].
double predict_volume(Predict* predict, const Body* body);

/// Pressure of a gas in the volume to which it brings the skin along dV/dx, exactly: p(V') of
/// V' = volume + weight (h^2 p(V') - given), `given` what of h^2 p is in the volume already,
/// `weight` dV per h^2 p.
double predict_pressure(const Inflation* gas, double volume, double weight, double h2,
                        double given);

/// The velocities that take the body by u; in body->f the forces that made them.
void predict_end(const Predict* predict, Body* body, double h);

void predict_close(Predict* predict);

#endif
