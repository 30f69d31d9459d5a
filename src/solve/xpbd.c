/// Extended position-based dynamics: backward Euler by one constraint after the other.
///
///     predict   u, the displacement without constraints (solve/predict.h)
///     relax     each constraint of energy E = C^2 / (2 a): change its impulse P of this step by
///               dP, so that P = -h^2 dE/dx to first order: u += w dP, w = 1 / (m + h c)
///     v' = u / h
///
/// An iteration relaxes all springs, eight at a time that share no particle (solve/batch/batches.h),
/// then strings, then the gas. The scene sets the number of iterations (default 1, for many small
/// steps). Converged iterations give the step of backward Euler; too few make the skin softer, by
/// an amount that depends on iterations, step and mesh. Order 1; never unstable; conserves linear
/// momentum to rounding, angular momentum to the method's order. Sources: M. Macklin, M.
/// Mueller, N. Chentanez, XPBD: position-based simulation of compliant constrained dynamics, 2016;
/// M. Macklin et al., Small steps in physics simulation, 2019.
///
/// springs    with d the length, n the direction, l = d / rest, a = 1/k and W the sum of both w
///
///                C = d - rest                                               hooke, and l < 1
///                C = rest (1 - l^-2) sqrt((2 l^2 + 1) / 12)                 rubber
///                C = 0                                                      tension, l < 1
///                C' = l (1 + l^-2 + l^-4) / (6 sqrt((2 l^2 + 1) / 12))      tension k C C'
///                dP = -(P.n + h^2 k C C') n / (1 + h^2 k C'^2 W)
///                     - (P - P.n n) / (1 + h^2 (k C C' / d) W)
///
///            From P = 0 this is the papers' step, where P.n is C' times their multiplier. The
///            papers keep the part of P across the present n; the second term of dP removes it, so
///            that converged impulses point along the springs.
/// strings    C = d - free length; P pulls, or is 0
/// gas        P = L dV/dx, L = h^2 p(V'), V' the volume after this change (predict_pressure)
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "solve/batch/batches.h"
#include "solve/method.h"
#include "solve/predict.h"

enum { ITERATIONS = 1 };

typedef struct Workspace {
    int iterations;
    double residual_max; ///< [1]
    Predict predict;
    Batches springs;
    double gas_impulse; ///< L [kg/m]
} Workspace;

static void* open(Body* body, const Solver* solver) {
    Workspace* workspace = new_array(Workspace, 1);
    workspace->iterations = solver->iterations > 0 ? solver->iterations : ITERATIONS;
    workspace->residual_max = solver->residual_max;
    batches_make(&workspace->springs, &body->springs, body->count);
    predict_open(&workspace->predict, body);
    return workspace;
}

static void close(void* self) {
    Workspace* workspace = self;
    if (!workspace)
        return;
    predict_close(&workspace->predict);
    batches_free(&workspace->springs);
    free(workspace);
}

/// Geometry of a string, of Hooke's law, at present positions.
typedef struct Stretched {
    real4 n;          ///< direction in which its length grows
    real pull, slope; ///< C C' [m], C'^2 [1]
    real length_now;  ///< [m]
} Stretched;

static inline Stretched stretched(real4 d, real rest) {
    const real l = length(d);
    return (Stretched){.n = d / l, .pull = l - rest, .slope = 1, .length_now = l};
}

/// dP of a constraint with the impulse P so far; `stiff` = h^2 k.
static inline real4 impulse_change(const Stretched* s, real stiff, real weight, real4 impulse) {
    const real along = dot(impulse, s->n);
    const real4 across = impulse - along * s->n;
    const real stiff_across = real_max(stiff * s->pull / s->length_now, 0);
    return -((along + stiff * s->pull) / (1 + stiff * s->slope * weight)) * s->n -
           across / (1 + stiff_across * weight);
}

static void relax_strings(Body* body, const real* weight, real h2, real4* u) {
    for (int k = 0; k < body->string_count; k++) {
        String* string = &body->string[k];
        const int i = string->particle;
        const real4 d = (body->x[i] - string->anchor) + u[i];
        if (!(dot(d, d) > 0))
            continue;
        const Stretched now = stretched(d, string->free_length);
        real4 next = string->impulse +
                     impulse_change(&now, h2 * string->stiffness, weight[i], string->impulse);
        if (dot(next, now.n) > 0) // a string does not push
            next = (real4){0, 0, 0, 0};
        u[i] += weight[i] * (next - string->impulse);
        string->impulse = next;
    }
}

static void relax_gas(Body* body, Workspace* workspace, double weight, double h2) {
    Inflation* gas = &body->inflation;
    gas->volume = predict_volume(&workspace->predict, body);
    const double next = h2 * predict_pressure(gas, gas->volume, weight, h2, workspace->gas_impulse);
    const real change = (real)(next - workspace->gas_impulse);
    workspace->gas_impulse = next;
    for (int i = 0; i < body->count; i++)
        workspace->predict.u[i] += (workspace->predict.weight[i] * change) * gas->gradient[i];
}

/// |dV/dx|^2_w
static double gas_weight(const Body* body, const real* weight) {
    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        const real4 g = body->inflation.gradient[i];
        sum += (double)(weight[i] * dot(g, g));
    }
    return sum;
}

static bool kick_body(Body* body, void* self, double h, SolveStats* stats) {
    Workspace* workspace = self;
    Predict* predict = &workspace->predict;
    const bool gas = body->inflation.law == INFLATE_GAS;
    const double h2 = h * h;
    *stats = (SolveStats){.iterations = workspace->iterations};

    predict_begin(predict, body, h);
    batches_begin(&workspace->springs, &body->springs, predict->weight, (real)h2);
    for (int k = 0; k < body->string_count; k++)
        body->string[k].impulse = (real4){0, 0, 0, 0};
    workspace->gas_impulse = 0;
    const double gas_w = gas ? gas_weight(body, predict->weight) : 0;

    for (int n = 0; n < workspace->iterations; n++) {
        batches_relax(&workspace->springs, body->springs.law, body->x, predict->u);
        relax_strings(body, predict->weight, (real)h2, predict->u);
        if (gas)
            relax_gas(body, workspace, gas_w, h2);
    }
    if (!predict_is_solved(predict, body, h, workspace->residual_max))
        return false;
    stats->residual = predict->check.residual;
    predict_end(predict, body, h);
    return true;
}

const Method method_xpbd = {
    .name = "xpbd",
    .about = "position-based constraints, order 1; too soft where iterations are few: split by the "
             "guard",
    .implicit = true,
    .iterates = true,
    .can_fail = true,
    .takes = predict_forces,
    .open = open,
    .close = close,
    .kick = system_kick,
    .kick_body = kick_body,
    .drift = body_drift,
};
