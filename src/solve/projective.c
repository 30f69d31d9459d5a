/// Projective dynamics: backward Euler by alternating local and global steps, with one matrix that
/// is factored in advance.
///
///     local     d_s, the present vector of spring s scaled to its rest length
///     global    A u' = (M + h C) u* + h^2 sum of k (d_s - e_s) over the springs, e_s their vectors
///               at x, u* the prediction (solve/predict.h), A = M + h C + h^2 L (factor.h)
///     v' = u / h
///
/// The global step is computed as u' = u + A^-1 r, r the residual of backward Euler's equation at
/// u: this is the same for Hooke's law, and |r| measures convergence. A string is a spring to a
/// fixed point; while it is slack, d_s is its present vector. A gas adds h^2 p(V') g, g = dV/dx,
/// which is of rank one: with z = A^-1 g once a step, V' = V + g . A^-1 r + g . z h^2 p(V') is one
/// equation for the number V' (for linear p, Woodbury's formula). Order 1; never unstable;
/// conserves linear momentum to rounding, angular momentum to the method's order. With too few
/// iterations the skin rotates and oscillates too slowly. Source: T. Liu, A. Bargteil, J. O'Brien,
/// L. Kavan, Fast simulation of mass-spring systems, 2013.
#include <stdlib.h>

#include "base/memory.h"
#include "force/damping.h"
#include "solve/factor.h"
#include "solve/method.h"
#include "solve/predict.h"

enum { ITERATIONS = 10 };

typedef struct Workspace {
    Solver solver;
    Predict predict;
    Factor* factor;
    double4* start;        ///< [count] u* [m]
    double4* u;            ///< [count] displacement of the step [m]
    double4* residual;     ///< [count] r without the gas [kg m]
    double4* gas_response; ///< [count] z [m^2/kg]; NULL without a gas
    double gas_weight;     ///< g . z [m^4/kg]
} Workspace;

static const char* refuses(const Body* body) {
    if (body->springs.count > 0 && body->springs.law != LAW_HOOKE)
        return "takes springs of Hooke's law only";
    return NULL;
}

static void* open(Body* body, const Solver* solver) {
    Workspace* workspace = new_array(Workspace, 1);
    workspace->solver = *solver;
    if (workspace->solver.iterations == 0)
        workspace->solver.iterations = ITERATIONS;
    predict_open(&workspace->predict, body);
    workspace->factor = factor_open(body);
    workspace->start = new_array(double4, body->count);
    workspace->u = new_array(double4, body->count);
    workspace->residual = new_array(double4, body->count);
    if (body->inflation.law == INFLATE_GAS)
        workspace->gas_response = new_array(double4, body->count);
    return workspace;
}

static void close(void* self) {
    Workspace* workspace = self;
    if (!workspace)
        return;
    predict_close(&workspace->predict);
    factor_close(workspace->factor);
    free(workspace->start);
    free(workspace->u);
    free(workspace->residual);
    free(workspace->gas_response);
    free(workspace);
}

/// h^2 times the force of a spring with the vector d, along d; `stiff` = h^2 k.
static inline double4 spring_pull(double4 d, double rest, double stiff) {
    const double l = dlength(d);
    return l > 0 ? stiff * (1 - rest / l) * d : d;
}

/// residual += h^2 times the forces of springs and strings at x + u
static void add_pulls(const Body* body, double h2, const double4* restrict u,
                      double4* restrict residual) {
    const Springs* springs = &body->springs;
    const real4* x = body->x;
    for (int s = 0; s < springs->count; s++) {
        const int i = springs->end[s][0], j = springs->end[s][1];
        const double4 d = to_double4(x[j] - x[i]) + (u[j] - u[i]);
        const double4 pull =
            spring_pull(d, (double)springs->rest[s], h2 * (double)springs->active[s]);
        residual[i] += pull;
        residual[j] -= pull;
    }
    for (int k = 0; k < body->string_count; k++) {
        const String* string = &body->string[k];
        const int i = string->particle;
        const double4 d = to_double4(x[i] - string->anchor) + u[i];
        if (dlength(d) > (double)string->free_length)
            residual[i] -=
                spring_pull(d, (double)string->free_length, h2 * (double)string->stiffness);
    }
}

/// Compute r without the gas; returns |r|_w of r with the gas at this pressure.
static double compute_residual(const Body* body, Workspace* workspace, double h, double pressure) {
    for (int i = 0; i < body->count; i++)
        workspace->residual[i] = ((double)body->mass[i] + h * damping_drag(body, i)) *
                                 (workspace->start[i] - workspace->u[i]);
    add_pulls(body, h * h, workspace->u, workspace->residual);

    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        if (body->inverse_mass[i] <= 0)
            workspace->residual[i] = (double4){0, 0, 0, 0};
        double4 total = workspace->residual[i];
        if (workspace->gas_response && body->inverse_mass[i] > 0)
            total += h * h * pressure * to_double4(body->inflation.gradient[i]);
        sum += (double)workspace->predict.weight[i] * ddot(total, total);
    }
    return sqrt(sum);
}

/// out = A^-1 right
static bool solve(Workspace* workspace, const double4* right, double4* out, int count) {
    double* b = factor_right(workspace->factor);
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            b[c * count + i] = right[i][c];
    const double* x = factor_solve(workspace->factor);
    for (int i = 0; x && i < count; i++)
        out[i] = (double4){x[i], x[count + i], x[2 * count + i], 0};
    return x != NULL;
}

static double along_gradient(const Body* body, const double4* d) {
    double sum = 0;
    for (int i = 0; i < body->count; i++)
        sum += ddot(to_double4(body->inflation.gradient[i]), d[i]);
    return sum;
}

/// z and g . z
static bool update_gas(const Body* body, Workspace* workspace) {
    for (int i = 0; i < body->count; i++)
        workspace->residual[i] = body->inverse_mass[i] > 0 ? to_double4(body->inflation.gradient[i])
                                                           : (double4){0, 0, 0, 0};
    if (!solve(workspace, workspace->residual, workspace->gas_response, body->count))
        return false;
    workspace->gas_weight = along_gradient(body, workspace->gas_response);
    return true;
}

/// Volume at x + u, with u rounded to the state's precision.
static double volume_at(const Body* body, Workspace* workspace) {
    for (int i = 0; i < body->count; i++)
        workspace->predict.u[i] = to_real4(workspace->u[i]);
    return predict_volume(&workspace->predict, body);
}

/// u' = u + A^-1 (r + h^2 p(V') g)
static bool improve_u(Body* body, Workspace* workspace, double h2) {
    double4* change = workspace->residual;
    if (!solve(workspace, workspace->residual, change, body->count))
        return false;
    double gas_impulse = 0;
    if (workspace->gas_response) {
        const Inflation* gas = &body->inflation;
        const double ahead = gas->volume + along_gradient(body, change);
        gas_impulse = h2 * predict_pressure(gas, ahead, workspace->gas_weight, h2, 0);
    }
    for (int i = 0; i < body->count; i++)
        workspace->u[i] += workspace->gas_response
                               ? change[i] + gas_impulse * workspace->gas_response[i]
                               : change[i];
    return true;
}

static bool kick_body(Body* body, void* self, double h, SolveStats* stats) {
    Workspace* workspace = self;
    const Solver* solver = &workspace->solver;
    *stats = (SolveStats){0};
    if (!factor_select(workspace->factor, body, h, &stats->factored))
        return false;
    predict_begin(&workspace->predict, body, h);
    for (int i = 0; i < body->count; i++)
        workspace->u[i] = workspace->start[i] = to_double4(workspace->predict.u[i]);
    if (workspace->gas_response && !update_gas(body, workspace))
        return false;

    for (double first = 0;; stats->iterations++) {
        double pressure = 0;
        if (workspace->gas_response) {
            body->inflation.volume = volume_at(body, workspace);
            pressure = gas_pressure(&body->inflation, body->inflation.volume);
        }
        const double size = compute_residual(body, workspace, h, pressure);
        if (!(size < INFINITY)) // a NaN solves nothing
            return false;
        first = fmax(first, size);
        stats->residual = first > 0 ? size / first : 0;
        if (stats->iterations == solver->iterations || stats->residual <= solver->tolerance)
            break;
        if (!improve_u(body, workspace, h * h))
            return false;
    }
    for (int i = 0; i < body->count; i++)
        workspace->predict.u[i] = to_real4(workspace->u[i]);
    if (!predict_is_solved(&workspace->predict, body, h, workspace->solver.residual_max))
        return false;
    predict_end(&workspace->predict, body, h);
    return true;
}

const Method method_projective = {
    .name = "projective",
    .about = "local and global steps on a factored matrix, order 1, Hooke's law; long steps: split "
             "by the guard",
    .implicit = true,
    .iterates = true,
    .can_fail = true,
    .takes = predict_forces,
    .refuses = refuses,
    .open = open,
    .close = close,
    .kick = system_kick,
    .kick_body = kick_body,
    .drift = body_drift,
};
