/// Extended position-based dynamics: backward Euler by one constraint after the other.
///
///     predict   u, where the particles would go without constraints (solve/predict.h)
///     relax     for each constraint of energy E = C^2 / (2 a), with its impulse P of this step,
///     what
///               takes P to -h^2 dE/dx to first order: u += w dP, w = 1 / (m + h c)
///     v' = u / h
///
/// Springs are taken eight at a time that share no particle (solve/batches.h), then strings, then
/// the gas; a round of all is an iteration, and a step makes as many as the scene says (1, with
/// small steps instead). Where rounds end early, stiffness is what got through: it depends on
/// iterations, step and mesh. Where they do not, the step is backward Euler's. Order 1; never
/// unstable; linear momentum to rounding, angular momentum to order. Sources: M. Macklin, M.
/// Mueller, N. Chentanez, XPBD: position-based simulation of compliant constrained dynamics, 2016;
/// M. Macklin et al., Small steps in physics simulation, 2019.
///
/// springs    with d the length, n the direction, l = d / rest, a = 1/k and W the sum of both w
///
///                C = d - rest                                               hooke, and l < 1
///                C = rest (1 - l^-2) sqrt((2 l^2 + 1) / 12)                 rubber
///                C = 0                                                      tension, l < 1
///                C' = l (1 + l^-2 + l^-4) / (6 sqrt((2 l^2 + 1) / 12))      C C' k is its pull
///                dP = -(P.n + h^2 k C C') n / (1 + h^2 k C'^2 W)
///                     - (P - P.n n) / (1 + h^2 (k C C' / d) W)
///
///            From P = 0 that is the papers' step, with P.n = C' times their multiplier. They go on
///            along the n of each round; taking back what has turned away costs nothing and leaves
///            nothing wrong in the end.
/// strings    C = d - free length; P pulls, or is 0
/// gas        P = L dV/dx, L = h^2 p of the volume to which it brings the skin (predict_pressure)
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "solve/batches.h"
#include "solve/method.h"
#include "solve/predict.h"

enum { ITERATIONS = 1 };

typedef struct Workspace {
    int iterations;
    Predict predict;
    Batches springs;
    double gas; ///< L [kg/m]
} Workspace;

static void* open(Body* body, const Solver* solver) {
    Workspace* workspace = new_array(Workspace, 1);
    workspace->iterations = solver->iterations > 0 ? solver->iterations : ITERATIONS;
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

/// A string now, of Hooke's law: the direction in which its length grows, its pull over the
/// stiffness, and how that grows.
typedef struct Stretched {
    real4 n;
    real pull, slope; ///< C C' [m], C'^2 [1]
    real now;         ///< length [m]
} Stretched;

static inline Stretched stretched(real4 d, real rest) {
    const real now = length(d);
    return (Stretched){.n = d / now, .pull = now - rest, .slope = 1, .now = now};
}

/// dP of a constraint that has given P so far, `stiff` = h^2 k.
static inline real4 change(const Stretched* s, real stiff, real weight, real4 given) {
    const real along = dot(given, s->n);
    const real4 aside = given - along * s->n;
    const real turned = real_max(stiff * s->pull / s->now, 0);
    return -((along + stiff * s->pull) / (1 + stiff * s->slope * weight)) * s->n -
           aside / (1 + turned * weight);
}

static void relax_strings(Body* body, const real* weight, real h2, real4* u) {
    for (int k = 0; k < body->string_count; k++) {
        String* string = &body->string[k];
        const int i = string->particle;
        const real4 d = (body->x[i] - string->anchor) + u[i];
        if (!(dot(d, d) > 0))
            continue;
        const Stretched now = stretched(d, string->free_length);
        real4 next =
            string->impulse + change(&now, h2 * string->stiffness, weight[i], string->impulse);
        if (dot(next, now.n) > 0) // it would push
            next = (real4){0, 0, 0, 0};
        u[i] += weight[i] * (next - string->impulse);
        string->impulse = next;
    }
}

static void relax_gas(Body* body, Workspace* workspace, double weight, double h2) {
    Inflation* gas = &body->inflation;
    gas->volume = predict_volume(&workspace->predict, body);
    const double next = h2 * predict_pressure(gas, gas->volume, weight, h2, workspace->gas);
    const real by = (real)(next - workspace->gas);
    workspace->gas = next;
    for (int i = 0; i < body->count; i++)
        workspace->predict.u[i] += (workspace->predict.weight[i] * by) * gas->gradient[i];
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
    workspace->gas = 0;
    const double gas_behind = gas ? gas_weight(body, predict->weight) : 0;

    for (int n = 0; n < workspace->iterations; n++) {
        batches_relax(&workspace->springs, body->springs.law, body->x, predict->u);
        relax_strings(body, predict->weight, (real)h2, predict->u);
        if (gas)
            relax_gas(body, workspace, gas_behind, h2);
    }
    predict_end(predict, body, h);
    return true;
}

const Method method_xpbd = {
    .name = "xpbd",
    .about = "position-based constraints, order 1, any step; soft where iterations are few",
    .implicit = true,
    .iterates = true,
    .takes = predict_forces,
    .open = open,
    .close = close,
    .kick = system_kick,
    .kick_body = kick_body,
    .drift = body_drift,
};
