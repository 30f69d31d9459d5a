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

/// When a step was last measured against Solver.residual_max: every CHECK_INTERVAL steps, every
/// CHECK_SECONDS, and every step longer than the last one that was good, for a measurement costs as
/// much as a step. Within 64 steps of 0.2 s a balloon can be filled and burst.
enum { CHECK_INTERVAL = 64 };
#define CHECK_SECONDS 0.1
typedef struct StepCheck {
    double longest;  ///< step that was good [s]
    int age;         ///< steps since
    double seconds;  ///< simulated time since [s]
    double residual; ///< then [1]
} StepCheck;

typedef struct Predict {
    real4* u;     ///< [count] displacement of the step [m]
    real4* ahead; ///< [count] x + u0 in predict_begin, x + u in predict_volume [m]
    real4* next;  ///< [count] velocities u / h, in predict_residual [m/s]
    real* weight; ///< [count] 1 / (m + h c), 0 where held [1/kg]
    StepCheck check;
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

/// Whether the residual of the step u is residual_max at most, where it is due to be measured. A
/// step of constraints that are relaxed too few times is softer than the skin: with a residual of
/// 0.23 a balloon of springs is 1 % too large, of 0.4 up to 5 %, of 0.97 half.
bool predict_is_solved(Predict* predict, Body* body, double h, double residual_max);

/// Set the velocities u / h, and in body->f the forces that they imply.
void predict_end(const Predict* predict, Body* body, double h);

void predict_close(Predict* predict);

#endif
