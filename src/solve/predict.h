/// The prediction that the methods of constraints share: a step without springs, strings and the
/// gas's pressure.
///
///     u0 = h m v / (m + h c)                 free motion with the drag c
///     u  = u0 + h^2 f(x + u0) / (m + h c)
///
/// f are the forces that these methods do not treat as constraints: weight, helium, lift, and the
/// pressure of inflation by area or at constant pressure. A gas acts along dV/dx, also taken at
/// x + u0; the method finds its pressure. At rest u0 = 0, so that the equilibrium is that of the
/// forces for every step h. Springs then add h^2 f / (m + h c) to u, which makes the step that of
/// backward Euler with its drag.
#ifndef BALLOON_SOLVE_PREDICT_H
#define BALLOON_SOLVE_PREDICT_H

#include "solve/method.h"

typedef struct Predict {
    real4* u;     ///< [count] displacement of the step [m]
    real4* ahead; ///< [count] x + u0 in predict_begin, x + u in predict_volume [m]
    real* weight; ///< [count] 1 / (m + h c), 0 where held [1/kg]
} Predict;

/// The forces that the methods of constraints take.
extern const ForceUse predict_forces[];

void predict_open(Predict* predict, const Body* body);

/// Compute u and weight; with a gas, also inflation.gradient.
void predict_begin(Predict* predict, Body* body, double h);

/// Volume of the skin at x + u [m^3].
double predict_volume(Predict* predict, const Body* body);

/// Pressure p(V') of a gas after it has moved the skin along dV/dx, exactly:
///
///     V' = volume + weight (h^2 p(V') - impulse)
///
/// `impulse`: the h^2 p that `volume` includes already [kg/m]; `weight`: dV per h^2 p [m^4/kg].
double predict_pressure(const Inflation* gas, double volume, double weight, double h2,
                        double impulse);

/// Set the velocities u / h, and in body->f the forces that they imply.
void predict_end(const Predict* predict, Body* body, double h);

void predict_close(Predict* predict);

#endif
