/// Backward Euler by Newton's method, as in the thin-shell paper, but with the exact volume term
/// and the first guess x + h v.
///
///     R(v') = M (v' - v) - h f(x + h v', v') = 0        the step's equation
///     A dv = -R                                         an iteration (solve/linear_solve.h)
///
/// A change dv that increases |R| is halved until |R| decreases or the incremental potential
///
///     P(v') = |v' - v|^2_M / 2 + h |v'|^2_D / 2 + E(x + h v')
///
/// does. Order 1; damps the modes that the step does not resolve; never unstable. Linear momentum
/// is conserved to the tolerance, angular momentum only to the method's order.
#include <stdlib.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/memory.h"
#include "force/damping.h"
#include "solve/linear_solve.h"
#include "solve/method.h"
#include "solve/residual.h"

static const Solver defaults = {.iterations = 50, .tolerance = 1e-6, .linear_tolerance = 1e-2};

enum { HALVINGS_MAX = 40 };

/// Longest way of a particle in one iteration: the tangent holds only near the present positions.
/// [of the body's size]
static const double way_max = 0.1;

typedef struct Workspace {
    Solver solver;
    real4* x_start;  ///< [count] positions at the start of the step
    real4* v_start;  ///< [count] velocities at the start of the step
    real4* residual; ///< [count] R
    real4* change;   ///< [count] dv
    LinearSolve linear;
} Workspace;

static void* open(Body* body, const Solver* solver) {
    Workspace* workspace = new_array(Workspace, 1);
    const int n = body->count;
    *workspace = (Workspace){
        .solver = *solver,
        .x_start = new_array(real4, n),
        .v_start = new_array(real4, n),
        .residual = new_array(real4, n),
        .change = new_array(real4, n),
    };
    linear_solve_open(&workspace->linear, body);
    if (workspace->solver.iterations == 0)
        workspace->solver.iterations = defaults.iterations;
    if (workspace->solver.tolerance == 0)
        workspace->solver.tolerance = defaults.tolerance;
    if (workspace->solver.linear_tolerance == 0)
        workspace->solver.linear_tolerance = defaults.linear_tolerance;
    return workspace;
}

static void close(void* self) {
    Workspace* workspace = self;
    if (!workspace)
        return;
    free(workspace->x_start);
    free(workspace->v_start);
    free(workspace->residual);
    free(workspace->change);
    linear_solve_close(&workspace->linear);
    free(workspace);
}

/// v' += part dv, x' = x + h v'.
static void move(Body* body, const Workspace* workspace, double part, double h) {
    for (int i = 0; i < body->count; i++) {
        body->v[i] += (real)part * workspace->change[i];
        body->x[i] = workspace->x_start[i] + (real)h * body->v[i];
    }
}

/// Compute R at v' and x'; returns |R|_(1/M).
static double evaluate_residual(Body* body, Workspace* workspace, double h) {
    force_sum(body);
    for (int i = 0; i < body->count; i++)
        workspace->residual[i] =
            body->inverse_mass[i] > 0
                ? body->mass[i] * (body->v[i] - workspace->v_start[i]) - (real)h * body->f[i]
                : (real4){0, 0, 0, 0};
    return inverse_mass_norm(body, workspace->residual);
}

/// P at v' and x'.
static double potential(const Body* body, const Workspace* workspace, double h) {
    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        const double4 v = to_double4(body->v[i]), dv = v - to_double4(workspace->v_start[i]);
        sum += (double)body->mass[i] * ddot(dv, dv) + h * damping_drag(body, i) * ddot(v, v);
    }
    sum /= 2;
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->energy && force_table[k]->present(body))
            sum += force_table[k]->energy(body);
    return sum;
}

/// Whether the volume of a gas was positive when the forces were last summed.
static bool has_volume(const Body* body) {
    return body->inflation.law != INFLATE_GAS || body->inflation.volume > 0;
}

/// The largest part of dv that moves no particle by more than way_max.
static double first_part(const Body* body, const Workspace* workspace, double h) {
    const double longest2 = (double)vectors()->max_squared(workspace->change, body->count);
    return fmin(1, way_max * body->size / (h * sqrt(longest2)));
}

/// Line search: move by dv, or by the first half, quarter ... of it that decreases |R|, leaves it
/// within `rounding`, or decreases P. Returns the new |R|, or less than 0 where no part does.
static double search_line(Body* body, Workspace* workspace, double before, double rounding,
                          double h) {
    double potential_before = NAN, moved = 0, part = first_part(body, workspace, h);
    for (int halving = 0; halving < HALVINGS_MAX; halving++, part /= 2) {
        if (halving == 1) { // P at the start of the search, which few searches need
            move(body, workspace, -moved, h);
            potential_before = potential(body, workspace, h);
            moved = 0;
        }
        move(body, workspace, part - moved, h);
        moved = part;
        const double after = evaluate_residual(body, workspace, h);
        if (!has_volume(body))
            continue;
        if (after <= fmax(before, rounding) ||
            (halving > 0 && potential(body, workspace, h) < potential_before))
            return after;
    }
    return -1;
}

static void restore_start(Body* body, const Workspace* workspace) {
    memcpy(body->x, workspace->x_start, (size_t)body->count * sizeof *body->x);
    memcpy(body->v, workspace->v_start, (size_t)body->count * sizeof *body->v);
}

/// Newton's iterations from a residual of norm `size`. False: the equation is not solved.
static bool iterate(Body* body, Workspace* workspace, double size, double h, SolveStats* stats) {
    const Solver* solver = &workspace->solver;
    const bool fixed_count = solver->tolerance < 0;
    if (!(size < INFINITY)) // a NaN solves nothing
        return false;
    const double scale = fmax(size, residual_scale(body, h));
    double size_max = fixed_count ? -1 : solver->tolerance * scale;
    while (stats->iterations < solver->iterations && size > size_max && !interrupt_signal()) {
        const double rounding = linear_solve_update(&workspace->linear, body, h);
        if (!(rounding < INFINITY)) // beyond the state's precision everything would be solved
            return false;
        if (!fixed_count)
            size_max = fmax(size_max, rounding);
        if (size <= size_max)
            break;
        linear_solve_run(&workspace->linear, body, h, solver->linear_tolerance, workspace->residual,
                         workspace->change, &stats->products);
        size = search_line(body, workspace, size, rounding, h);
        stats->iterations++;
        if (!(size >= 0))
            return false;
    }
    stats->residual = scale > 0 ? size / scale : 0;
    return (fixed_count && size < INFINITY) || size <= size_max;
}

static void stop(Body* body) {
    memset(body->v, 0, (size_t)body->count * sizeof *body->v);
}

static bool kick_body(Body* body, void* self, double h, SolveStats* stats) {
    Workspace* workspace = self;
    linear_solve_begin(&workspace->linear, body);
    *stats = (SolveStats){0};
    memcpy(workspace->x_start, body->x, (size_t)body->count * sizeof *workspace->x_start);
    memset(workspace->change, 0, (size_t)body->count * sizeof *workspace->change);
    if (workspace->solver.start == START_REST)
        stop(body);
    memcpy(workspace->v_start, body->v, (size_t)body->count * sizeof *workspace->v_start);
    move(body, workspace, 0, h);
    double size = evaluate_residual(body, workspace, h);
    if (!has_volume(body)) { // free motion would turn it inside out: start from x instead
        stop(body);
        move(body, workspace, 0, h);
        size = evaluate_residual(body, workspace, h);
    }

    const bool solved = iterate(body, workspace, size, h, stats);
    if (!solved)
        restore_start(body, workspace);
    else
        memcpy(body->x, workspace->x_start,
               (size_t)body->count * sizeof *body->x); // the drift is to come
    return solved;
}

const Method method_newton = {
    .name = "newton",
    .about = "backward Euler by Newton and conjugate gradients, order 1, any step",
    .implicit = true,
    .iterates = true,
    .multiplies = true,
    .can_fail = true,
    .open = open,
    .close = close,
    .kick = system_kick,
    .kick_body = kick_body,
    .drift = body_drift,
};
