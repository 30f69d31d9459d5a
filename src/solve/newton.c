/// Backward Euler by Newton's method and conjugate gradients, the thin-shell paper's way, with the
/// volume term exact and the start at x + h v.
///
///     R(v') = M (v' - v) - h f(x + h v', v') = 0        the step's equation
///     A dv = -R,  A = M + h D + h^2 K                   D drag, K = -df/dx, made positive
///
/// K's blocks are assembled (force/tangent.h), what is dense, as the gas's rank-one part, each
/// force multiplies by itself. A is preconditioned by a cycle through coarser skins (multigrid/multigrid.h).
/// A step dv that leaves more of R than there was is halved until less is left or the incremental
/// potential
///
///     P(v') = |v' - v|^2_M / 2 + h |v'|^2_D / 2 + E(x + h v')
///
/// falls. Order 1; damps what it does not resolve; never unstable. Linear momentum is kept to the
/// tolerance, angular momentum only to order.
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/vectors.h"
#include "force/tangent.h"
#include "solve/method.h"
#include "solve/multigrid/multigrid.h"

static const Solver usual = {.iterations = 50, .tolerance = 1e-6, .linear_tolerance = 1e-2};

enum { PRODUCTS_MOST = 2000, HALVINGS_MOST = 40 };

/// The coarser skins keep following an old tangent until a linear solution takes this many times
/// the products that it took when they were new, and as many more. [1]
static const double stale_share = 1.25;
static const int stale_more = 8;
enum { STALE_AGE = 40 }; ///< nor for more tangents than these

/// No particle goes farther in one iteration, for the tangent knows nothing of what is there. [of
/// the body's size]
static const double farthest = 0.1;

typedef struct Workspace {
    Solver solver;
    real4* x;        ///< [count] positions at the start of the step
    real4* v;        ///< [count] velocities at the start of the step
    real4* residual; ///< [count] R
    real4* change;   ///< [count] dv
    real4* left;     ///< [count] of the linear equation
    real4* search;   ///< [count] direction
    real4* image;    ///< [count] A times direction
    real4* ready;    ///< [count] preconditioned remainder
    Tangent tangent; ///< A
    Multigrid levels;
    double
        levels_h; ///< step of the tangent that the coarser skins follow [s]; 0: none that is good
    int age;      ///< tangents since then
    bool holds;   ///< some particles do not move
    int fresh;    ///< products of the first solution with it; 0: not known yet
} Workspace;

static void* open(Body* body, const Solver* solver) {
    Workspace* workspace = new_array(Workspace, 1);
    const int n = body->count;
    *workspace = (Workspace){
        .solver = *solver,
        .x = new_array(real4, n),
        .v = new_array(real4, n),
        .residual = new_array(real4, n),
        .change = new_array(real4, n),
        .left = new_array(real4, n),
        .search = new_array(real4, n),
        .image = new_array(real4, n),
        .ready = new_array(real4, n),
    };
    tangent_open(&workspace->tangent, body);
    multigrid_open(&workspace->levels, &workspace->tangent.matrix, body->inverse_mass);
    if (workspace->solver.iterations == 0)
        workspace->solver.iterations = usual.iterations;
    if (workspace->solver.tolerance == 0)
        workspace->solver.tolerance = usual.tolerance;
    if (workspace->solver.linear_tolerance == 0)
        workspace->solver.linear_tolerance = usual.linear_tolerance;
    return workspace;
}

static void close(void* self) {
    Workspace* workspace = self;
    if (!workspace)
        return;
    free(workspace->x);
    free(workspace->v);
    free(workspace->residual);
    free(workspace->change);
    free(workspace->left);
    free(workspace->search);
    free(workspace->image);
    free(workspace->ready);
    tangent_close(&workspace->tangent);
    multigrid_close(&workspace->levels);
    free(workspace);
}

/// The body at the velocities that are tried: v' = v' + part dv, x' = x + h v'.
static void go(Body* body, const Workspace* workspace, double part, double h) {
    for (int i = 0; i < body->count; i++) {
        body->v[i] += (real)part * workspace->change[i];
        body->x[i] = workspace->x[i] + (real)h * body->v[i];
    }
}

static double weigh(const Body* body, const real4* r) {
    return sqrt(vectors()->weigh(body->inverse_mass, r, body->count));
}

/// R at the present v' and x', and its size |R|_(1/M).
static double residual(Body* body, Workspace* workspace, double h) {
    force_sum(body);
    for (int i = 0; i < body->count; i++)
        workspace->residual[i] =
            body->inverse_mass[i] > 0
                ? body->mass[i] * (body->v[i] - workspace->v[i]) - (real)h * body->f[i]
                : (real4){0, 0, 0, 0};
    return weigh(body, workspace->residual);
}

/// What R is measured against: the forces that cancel in it, each by itself, times h.
static double measure_of(Body* body, double h) {
    double sum = 0;
    for (int k = 0; k < force_count; k++) {
        if (!force_table[k]->present(body))
            continue;
        memset(body->f, 0, (size_t)body->count * sizeof *body->f);
        force_add(force_table[k], body);
        const double size = weigh(body, body->f);
        sum += size * size;
    }
    return h * sqrt(sum);
}

/// P, against the velocities at the start.
static double potential(const Body* body, const Workspace* workspace, double h) {
    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        const double4 v = to_double4(body->v[i]), dv = v - to_double4(workspace->v[i]);
        sum += (double)body->mass[i] * ddot(dv, dv) + h * body_drag(body, i) * ddot(v, v);
    }
    sum /= 2;
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->energy && force_table[k]->present(body))
            sum += force_table[k]->energy(body);
    return sum;
}

/// A, at the present x'. Returns the rounding of R: a position is right to half of its last bit,
/// and K turns that into force; so is a velocity. 1/2 to 3/4 of this is what is reached, in both
/// precisions.
static double ready(Body* body, Workspace* workspace, double h, bool project) {
    tangent_ready(&workspace->tangent, body, h * h, project);
    double noise = 0;
    for (int i = 0; i < body->count; i++) {
        Block* block = block_matrix_diagonal(&workspace->tangent.matrix, i);
        const real place = length(body->x[i]);
        for (int c = 0; c < 3; c++) {
            const double force = (double)(block->column[c][c] * place) / h;
            noise += (double)body->inverse_mass[i] * force * force;
            block->column[c][c] += body->mass[i] + (real)(h * body_drag(body, i));
        }
        noise += (double)(body->mass[i] * dot(body->v[i], body->v[i]));
    }
    const bool all = project || workspace->levels_h != h;
    multigrid_ready(&workspace->levels, body->x, all);
    if (all)
        workspace->fresh = workspace->age = 0;
    workspace->age++;
    workspace->levels_h = workspace->age < STALE_AGE ? h : 0;
    return (double)REAL_EPSILON / 2 * sqrt(noise);
}

/// What is held neither moves nor feels.
static void keep_held(const Body* body, const Workspace* workspace, real4* a) {
    for (int i = 0; workspace->holds && i < body->count; i++)
        if (!(body->inverse_mass[i] > 0))
            a[i] = (real4){0, 0, 0, 0};
}

/// out = A d
static void multiply(const Body* body, const Workspace* workspace, const real4* d, double h,
                     real4* out) {
    multigrid_multiply(&workspace->levels, d, out);
    tangent_add_dense(body, h * h, d, out);
    keep_held(body, workspace, out);
}

/// ready = preconditioner times left; returns left . ready.
static double precondition(const Body* body, Workspace* workspace) {
    const double along = multigrid_apply(&workspace->levels, workspace->left, workspace->ready);
    keep_held(body, workspace, workspace->ready); // left is zero there
    return along;
}

/// Where A is soft in a few directions, what is left in the others weighs nothing in A's own norm;
/// a solution must leave no more than this share of R. [1]
static const double left_most = 0.5;

/// Solve A dv = -R. False where A turns out not to be positive.
static bool solve_linear(Body* body, Workspace* workspace, double h, SolveStats* stats) {
    for (int i = 0; i < body->count; i++)
        workspace->left[i] = -workspace->residual[i];
    memset(workspace->change, 0, (size_t)body->count * sizeof *workspace->change);

    const double most = left_most * weigh(body, workspace->residual);
    double size = precondition(body, workspace);
    const double enough =
        size * workspace->solver.linear_tolerance * workspace->solver.linear_tolerance;
    memcpy(workspace->search, workspace->ready, (size_t)body->count * sizeof *workspace->search);
    for (int n = 0; n < PRODUCTS_MOST; n++) {
        if (size <= enough && weigh(body, workspace->left) <= most)
            break;
        multiply(body, workspace, workspace->search, h, workspace->image);
        stats->products++;
        const double curvature = vectors()->dot(workspace->search, workspace->image, body->count);
        if (!(curvature > 0))
            return false;
        const real step = (real)(size / curvature);
        vectors()->add(workspace->change, step, workspace->search, body->count);
        vectors()->add(workspace->left, -step, workspace->image, body->count);
        const double last = size;
        size = precondition(body, workspace);
        if (!(size >= 0))
            return false;
        vectors()->turn(workspace->search, (real)(size / last), workspace->ready, body->count);
    }
    return true;
}

/// Whether the gas, if there is one, had a volume when the forces were last summed.
static bool has_room(const Body* body) {
    return body->inflation.law != INFLATE_GAS || body->inflation.volume > 0;
}

/// The part of dv that is not too far.
static double first_part(const Body* body, const Workspace* workspace, double h) {
    const double most = (double)vectors()->most(workspace->change, body->count);
    return fmin(1, farthest * body->size / (h * sqrt(most)));
}

/// Take dv, or as much of it as makes things better, where they are worse than `rounding`. Returns
/// the residual's new size, or less than 0 where no part of dv does.
static double take(Body* body, Workspace* workspace, double before, double rounding, double h) {
    double potential_before = NAN, taken = 0, part = first_part(body, workspace, h);
    for (int halving = 0; halving < HALVINGS_MOST; halving++, part /= 2) {
        if (halving == 1) { // the first part was not good: what was it worth before?
            go(body, workspace, -taken, h);
            potential_before = potential(body, workspace, h);
            taken = 0;
        }
        go(body, workspace, part - taken, h);
        taken = part;
        const double after = residual(body, workspace, h);
        if (!has_room(body))
            continue;
        if (after <= fmax(before, rounding) ||
            (halving > 0 && potential(body, workspace, h) < potential_before))
            return after;
    }
    return -1;
}

static void put_back(Body* body, const Workspace* workspace) {
    memcpy(body->x, workspace->x, (size_t)body->count * sizeof *body->x);
    memcpy(body->v, workspace->v, (size_t)body->count * sizeof *body->v);
}

/// dv by the full tangent, or where that is not positive by the part of it that is, which also
/// leads downhill.
static void find_change(Body* body, Workspace* workspace, double h, SolveStats* stats) {
    const int before = stats->products;
    if (!solve_linear(body, workspace, h, stats)) {
        ready(body, workspace, h, true);
        solve_linear(body, workspace, h, stats);
        workspace->levels_h = 0;
        return;
    }
    const int products = stats->products - before;
    if (workspace->fresh == 0)
        workspace->fresh = products;
    else if (products > stale_share * workspace->fresh + stale_more)
        workspace->levels_h = 0;
}

static bool solve(Body* body, Workspace* workspace, double size, double h, SolveStats* stats) {
    const Solver* solver = &workspace->solver;
    const bool counted = solver->tolerance < 0;
    const double scale = fmax(size, measure_of(body, h));
    double enough = counted ? -1 : solver->tolerance * scale;
    while (stats->iterations < solver->iterations && size > enough) {
        const double rounding = ready(body, workspace, h, false);
        if (!counted)
            enough = fmax(enough, rounding);
        if (size <= enough)
            break;
        find_change(body, workspace, h, stats);
        size = take(body, workspace, size, rounding, h);
        stats->iterations++;
        if (!(size >= 0))
            return false;
    }
    stats->residual = scale > 0 ? size / scale : 0;
    return counted || size <= enough;
}

static void rest(Body* body) {
    memset(body->v, 0, (size_t)body->count * sizeof *body->v);
}

static bool holds_some(const Body* body) {
    for (int i = 0; i < body->count; i++)
        if (!(body->inverse_mass[i] > 0))
            return true;
    return false;
}

static bool kick_body(Body* body, void* self, double h, SolveStats* stats) {
    Workspace* workspace = self;
    workspace->holds = holds_some(body);
    *stats = (SolveStats){0};
    memcpy(workspace->x, body->x, (size_t)body->count * sizeof *workspace->x);
    memset(workspace->change, 0, (size_t)body->count * sizeof *workspace->change);
    if (workspace->solver.start == START_REST)
        rest(body);
    memcpy(workspace->v, body->v, (size_t)body->count * sizeof *workspace->v);
    go(body, workspace, 0, h);
    double size = residual(body, workspace, h);
    if (!has_room(body)) { // it would turn inside out by itself: begin where it is
        rest(body);
        go(body, workspace, 0, h);
        size = residual(body, workspace, h);
    }

    const bool solved = solve(body, workspace, size, h, stats);
    if (!solved)
        put_back(body, workspace);
    else
        memcpy(body->x, workspace->x,
               (size_t)body->count * sizeof *body->x); // the drift is to come
    return solved;
}

const Method method_newton = {
    .name = "newton",
    .about = "backward Euler by Newton and conjugate gradients, order 1, any step",
    .implicit = true,
    .iterates = true,
    .can_fail = true,
    .open = open,
    .close = close,
    .kick = system_kick,
    .kick_body = kick_body,
    .drift = body_drift,
};
