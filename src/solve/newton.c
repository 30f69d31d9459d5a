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
/// does. Contacts are terms of the same equation, with all bodies and balls that they couple
/// (solve/contact_terms.h, solve/group.h). Order 1; damps the modes that the step does not resolve; never unstable. Linear momentum
/// is conserved to the tolerance, angular momentum only to the method's order.
#include <stdlib.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/memory.h"
#include "base/vectors.h"
#include "force/damping.h"
#include "solve/group_vector.h"
#include "solve/linear_solve.h"
#include "solve/method.h"
#include "solve/residual.h"

static const Solver defaults = {.iterations = 50, .tolerance = 1e-6, .linear_tolerance = 1e-2};

enum { HALVINGS_MAX = 40 };

/// Longest way of a particle in one iteration: the tangent holds only near the present positions.
/// [of the body's size]
static const double way_max = 0.1;

/// Contacts' multipliers are updated where Newton's iterations have made the residual this much less
/// than the last update left; after every iteration they would run ahead of the velocities. They
/// converge linearly: once an update leaves less than contact_tolerance, the next one waits until the
/// equation is solved. [1]
static const double update_share = 0.1;

/// |R| for updated multipliers at which contacts are solved; contacts_finish solves what remains of
/// an overlap. [of the residual's scale]
static const double contact_tolerance = 7e-4;

/// Tighter tolerances are solved without contacts. [1]
static const double contact_residual_min = 1e-7;

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
static void move(Group* group, double part, double h) {
    for (int k = 0; k < group->body_count; k++) {
        Body* body = group->body[k].body;
        const Workspace* workspace = group->body[k].workspace;
        for (int i = 0; i < body->count; i++) {
            body->v[i] += (real)part * workspace->change[i];
            body->x[i] = workspace->x_start[i] + (real)h * body->v[i];
        }
    }
    for (int s = 0; s < group->ball_count; s++) {
        const GroupBall* ball = &group->ball[s];
        ball->sphere->v += (real)part * ball->vector[GROUP_CHANGE][0];
        ball->sphere->spin += (real)part * ball->vector[GROUP_CHANGE][1];
    }
}

/// Compute R at v' and x'; returns |R|_(1/M).
static double evaluate_residual(Group* group, double h) {
    for (int k = 0; k < group->body_count; k++) {
        Body* body = group->body[k].body;
        const Workspace* workspace = group->body[k].workspace;
        force_sum(body);
        for (int i = 0; i < body->count; i++)
            workspace->residual[i] =
                body->inverse_mass[i] > 0
                    ? body->mass[i] * (body->v[i] - workspace->v_start[i]) - (real)h * body->f[i]
                    : (real4){0, 0, 0, 0};
    }
    for (int s = 0; s < group->ball_count; s++) {
        GroupBall* ball = &group->ball[s];
        const Sphere* sphere = ball->sphere;
        ball->vector[GROUP_RESIDUAL][0] = sphere->mass * (sphere->v - ball->v_start);
        ball->vector[GROUP_RESIDUAL][1] =
            sphere_inertia(sphere) * (sphere->spin - ball->spin_start);
    }
    contact_terms_add_impulses(group);
    joint_terms_add_impulses(group, h);
    return group_inverse_mass_norm(group, GROUP_RESIDUAL);
}

/// P at v' and x'.
static double potential(const Group* group, double h) {
    double all = 0;
    for (int b = 0; b < group->body_count; b++) {
        const Body* body = group->body[b].body;
        const Workspace* workspace = group->body[b].workspace;
        double sum = 0;
        for (int i = 0; i < body->count; i++) {
            const double4 v = to_double4(body->v[i]), dv = v - to_double4(workspace->v_start[i]);
            sum += (double)body->mass[i] * ddot(dv, dv) + h * damping_drag(body, i) * ddot(v, v);
        }
        sum /= 2;
        for (int k = 0; k < force_count; k++)
            if (force_table[k]->energy && force_table[k]->present(body))
                sum += force_table[k]->energy(body);
        all += sum;
    }
    return all + contact_terms_potential(group) + joint_terms_potential(group, h);
}

/// Whether the volumes of all gases were positive when the forces were last summed.
static bool has_volume(const Group* group) {
    for (int k = 0; k < group->body_count; k++) {
        const Inflation* gas = &group->body[k].body->inflation;
        if (gas->law == INFLATE_GAS && !(gas->volume > 0))
            return false;
    }
    return true;
}

/// The largest part of dv that moves no particle by more than way_max.
static double first_part(const Group* group, double h) {
    double part = 1;
    for (int k = 0; k < group->body_count; k++) {
        const Body* body = group->body[k].body;
        const Workspace* workspace = group->body[k].workspace;
        const double longest2 = (double)vectors()->max_squared(workspace->change, body->count);
        part = fmin(part, way_max * body->size / (h * sqrt(longest2)));
    }
    return part;
}

/// Line search: move by dv, or by the first half, quarter ... of it that decreases |R|, leaves it
/// within `rounding`, or decreases P. Contacts that open or close increase |R| on the way to less P:
/// with contacts the whole of dv is judged by P, too. Returns the new |R|, or less than 0 where no
/// part does.
static double search_line(Group* group, double before, double rounding, double h) {
    const int first_judged = group->term_count > 0 ? 0 : 1; // P, which few searches need otherwise
    double potential_before = NAN, moved = 0, part = first_part(group, h);
    for (int halving = 0; halving < HALVINGS_MAX; halving++, part /= 2) {
        if (halving == first_judged) { // P at the start of the search
            move(group, -moved, h);
            contact_terms_evaluate(group);
            potential_before = potential(group, h);
            moved = 0;
        }
        move(group, part - moved, h);
        moved = part;
        const double after = evaluate_residual(group, h);
        if (!has_volume(group))
            continue;
        if (after <= fmax(before, rounding) ||
            (halving >= first_judged && potential(group, h) < potential_before))
            return after;
    }
    return -1;
}

static void restore_positions(const Group* group) {
    for (int k = 0; k < group->body_count; k++) {
        Body* body = group->body[k].body;
        const Workspace* workspace = group->body[k].workspace;
        memcpy(body->x, workspace->x_start, (size_t)body->count * sizeof *body->x);
    }
}

static void restore_velocities(const Group* group) {
    for (int k = 0; k < group->body_count; k++) {
        Body* body = group->body[k].body;
        const Workspace* workspace = group->body[k].workspace;
        memcpy(body->v, workspace->v_start, (size_t)body->count * sizeof *body->v);
    }
}

/// The bodies' scales together (solve/residual.h).
static double group_scale(const Group* group, double h) {
    double scale = residual_scale(group->body[0].body, h);
    for (int k = 1; k < group->body_count; k++) {
        const double more = residual_scale(group->body[k].body, h);
        scale = sqrt(scale * scale + more * more);
    }
    return scale;
}

/// Update the contacts' multipliers L if |R| is small enough. Returns |R| for the new L: it measures
/// how far the contacts are from what they demand. *solved: R and the contacts are within tolerance.
static double update_contacts(Group* group, double size, double* size_updated, double size_max,
                              double contact_max, bool* solved) {
    if (!(size <= size_max ||
          (*size_updated > contact_max && size <= update_share * *size_updated)))
        return size;
    contact_terms_update_multipliers(group);
    *size_updated = group_inverse_mass_norm(group, GROUP_RESIDUAL);
    *solved = size <= size_max && *size_updated <= fmax(size_max, contact_max);
    if (!*solved)
        return *size_updated;
    contact_terms_undo_update(group); // the velocities are those of the impulses before
    return size;
}

/// Newton's iterations from a residual of norm `size`. False: the equation is not solved.
static bool iterate(Group* group, const Solver* solver, double size, double h, SolveStats* stats) {
    const bool fixed_count = solver->tolerance<0, touches = group->term_count> 0;
    if (!(size < INFINITY)) // a NaN solves nothing
        return false;
    const double scale = fmax(size, group_scale(group, h));
    double size_max = fixed_count ? -1 : solver->tolerance * scale, size_updated = 0;
    bool solved = !touches && size <= size_max; // with contacts, k must be known first
    while (stats->iterations < solver->iterations && !solved && !interrupt_signal()) {
        const double rounding = linear_solve_update(group, h);
        if (!(rounding < INFINITY)) // beyond the state's precision everything would be solved
            return false;
        if (!fixed_count)
            size_max = fmax(size_max, rounding);
        if (touches && stats->iterations == 0)
            size = size_updated = group_inverse_mass_norm(group, GROUP_RESIDUAL);
        solved = size <= size_max;
        if (solved)
            break;
        linear_solve_run(group, h, solver->linear_tolerance, &stats->products);
        size = search_line(group, size, rounding, h);
        stats->iterations++;
        if (!(size >= 0))
            return false;
        if (touches)
            size = update_contacts(group, size, &size_updated, size_max, contact_tolerance * scale,
                                   &solved);
        else
            solved = size <= size_max;
    }
    stats->residual = scale > 0 ? size / scale : 0;
    return (fixed_count && size < INFINITY) || solved;
}

/// Held particles move as what holds them.
static void stop_body(const Body* body) {
    for (int i = 0; i < body->count; i++)
        if (body->inverse_mass[i] > 0)
            body->v[i] = (real4){0, 0, 0, 0};
}

/// The start of the step, and where the vectors of the equation are.
static void begin(Group* group) {
    for (int k = 0; k < group->body_count; k++) {
        GroupBody* part = &group->body[k];
        Workspace* workspace = part->workspace;
        Body* body = part->body;
        const size_t bytes = (size_t)body->count * sizeof *body->x;
        linear_solve_begin(&workspace->linear, body);
        part->linear = &workspace->linear;
        part->matrix = &workspace->linear.tangent.matrix;
        part->vector[GROUP_RESIDUAL] = workspace->residual;
        part->vector[GROUP_CHANGE] = workspace->change;
        part->vector[GROUP_REMAINDER] = workspace->linear.residual;
        part->vector[GROUP_PRECONDITIONED] = workspace->linear.preconditioned;
        part->vector[GROUP_DIRECTION] = workspace->linear.direction;
        part->vector[GROUP_IMAGE] = workspace->linear.image;
        memcpy(workspace->x_start, body->x, bytes);
        if (workspace->solver.start == START_REST)
            stop_body(body);
        memcpy(workspace->v_start, body->v, bytes);
    }
    group_clear(group, GROUP_CHANGE);
}

static bool kick_group(Group* group, double h) {
    SolveStats stats = {0};
    begin(group);
    move(group, 0, h);
    double size = evaluate_residual(group, h);
    if (!has_volume(group)) { // free motion would turn it inside out: start from x instead
        for (int k = 0; k < group->body_count; k++)
            stop_body(group->body[k].body);
        move(group, 0, h);
        size = evaluate_residual(group, h);
    }

    const Workspace* first = group->body[0].workspace; // all have the scene's solver
    const bool solved = iterate(group, &first->solver, size, h, &stats);
    restore_positions(group); // the drift is to come
    if (!solved)
        restore_velocities(group);
    for (int k = 0; k < group->body_count; k++)
        *group->body[k].stats = stats;
    return solved;
}

static bool kick_body(Body* body, void* workspace, double h, SolveStats* stats) {
    GroupBody part = {.body = body, .workspace = workspace, .stats = stats};
    return kick_group(&(Group){.body = &part, .body_count = 1}, h);
}

/// The multipliers of contacts converge linearly: a residual of 1e-12 is not reached with them.
static bool solves_contacts(const void* self) {
    const Workspace* workspace = self;
    return !(workspace->solver.tolerance >= 0 &&
             workspace->solver.tolerance < contact_residual_min);
}

const Method method_newton = {
    .name = "newton",
    .about = "backward Euler by Newton and conjugate gradients, order 1, any step",
    .implicit = true,
    .iterates = true,
    .multiplies = true,
    .can_fail = true,
    .joins = true,
    .open = open,
    .close = close,
    .kick = system_kick,
    .kick_body = kick_body,
    .kick_group = kick_group,
    .solves_contacts = solves_contacts,
    .drift = body_drift,
};
