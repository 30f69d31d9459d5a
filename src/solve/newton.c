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

typedef struct Room {
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
} Room;

static void* open(Body* body, const Solver* solver) {
    Room* room = new_array(Room, 1);
    const int n = body->count;
    *room = (Room){
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
    tangent_open(&room->tangent, body);
    multigrid_open(&room->levels, &room->tangent.matrix, body->inverse_mass);
    if (room->solver.iterations == 0)
        room->solver.iterations = usual.iterations;
    if (room->solver.tolerance == 0)
        room->solver.tolerance = usual.tolerance;
    if (room->solver.linear_tolerance == 0)
        room->solver.linear_tolerance = usual.linear_tolerance;
    return room;
}

static void close(void* self) {
    Room* room = self;
    if (!room)
        return;
    free(room->x);
    free(room->v);
    free(room->residual);
    free(room->change);
    free(room->left);
    free(room->search);
    free(room->image);
    free(room->ready);
    tangent_close(&room->tangent);
    multigrid_close(&room->levels);
    free(room);
}

/// The body at the velocities that are tried: v' = v' + part dv, x' = x + h v'.
static void go(Body* body, const Room* room, double part, double h) {
    for (int i = 0; i < body->count; i++) {
        body->v[i] += (real)part * room->change[i];
        body->x[i] = room->x[i] + (real)h * body->v[i];
    }
}

static double weigh(const Body* body, const real4* r) {
    return sqrt(vectors()->weigh(body->inverse_mass, r, body->count));
}

/// R at the present v' and x', and its size |R|_(1/M).
static double residual(Body* body, Room* room, double h) {
    force_sum(body);
    for (int i = 0; i < body->count; i++)
        room->residual[i] = body->inverse_mass[i] > 0
                                ? body->mass[i] * (body->v[i] - room->v[i]) - (real)h * body->f[i]
                                : (real4){0, 0, 0, 0};
    return weigh(body, room->residual);
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
static double potential(const Body* body, const Room* room, double h) {
    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        const double4 v = to_double4(body->v[i]), dv = v - to_double4(room->v[i]);
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
static double ready(Body* body, Room* room, double h, bool project) {
    tangent_ready(&room->tangent, body, h * h, project);
    double noise = 0;
    for (int i = 0; i < body->count; i++) {
        Block* block = block_matrix_diagonal(&room->tangent.matrix, i);
        const real place = length(body->x[i]);
        for (int c = 0; c < 3; c++) {
            const double force = (double)(block->column[c][c] * place) / h;
            noise += (double)body->inverse_mass[i] * force * force;
            block->column[c][c] += body->mass[i] + (real)(h * body_drag(body, i));
        }
        noise += (double)(body->mass[i] * dot(body->v[i], body->v[i]));
    }
    const bool all = project || room->levels_h != h;
    multigrid_ready(&room->levels, body->x, all);
    if (all)
        room->fresh = room->age = 0;
    room->age++;
    room->levels_h = room->age < STALE_AGE ? h : 0;
    return (double)REAL_EPSILON / 2 * sqrt(noise);
}

/// What is held neither moves nor feels.
static void keep_held(const Body* body, const Room* room, real4* a) {
    for (int i = 0; room->holds && i < body->count; i++)
        if (!(body->inverse_mass[i] > 0))
            a[i] = (real4){0, 0, 0, 0};
}

/// out = A d
static void multiply(const Body* body, const Room* room, const real4* d, double h, real4* out) {
    multigrid_multiply(&room->levels, d, out);
    tangent_add_dense(body, h * h, d, out);
    keep_held(body, room, out);
}

/// ready = preconditioner times left; returns left . ready.
static double precondition(const Body* body, Room* room) {
    const double along = multigrid_apply(&room->levels, room->left, room->ready);
    keep_held(body, room, room->ready); // left is zero there
    return along;
}

/// Where A is soft in a few directions, what is left in the others weighs nothing in A's own norm;
/// a solution must leave no more than this share of R. [1]
static const double left_most = 0.5;

/// Solve A dv = -R. False where A turns out not to be positive.
static bool solve_linear(Body* body, Room* room, double h, Effort* effort) {
    for (int i = 0; i < body->count; i++)
        room->left[i] = -room->residual[i];
    memset(room->change, 0, (size_t)body->count * sizeof *room->change);

    const double most = left_most * weigh(body, room->residual);
    double size = precondition(body, room);
    const double enough = size * room->solver.linear_tolerance * room->solver.linear_tolerance;
    memcpy(room->search, room->ready, (size_t)body->count * sizeof *room->search);
    for (int n = 0; n < PRODUCTS_MOST; n++) {
        if (size <= enough && weigh(body, room->left) <= most)
            break;
        multiply(body, room, room->search, h, room->image);
        effort->products++;
        const double curvature = vectors()->dot(room->search, room->image, body->count);
        if (!(curvature > 0))
            return false;
        const real step = (real)(size / curvature);
        vectors()->add(room->change, step, room->search, body->count);
        vectors()->add(room->left, -step, room->image, body->count);
        const double last = size;
        size = precondition(body, room);
        if (!(size >= 0))
            return false;
        vectors()->turn(room->search, (real)(size / last), room->ready, body->count);
    }
    return true;
}

/// Whether the gas, if there is one, had a volume when the forces were last summed.
static bool has_room(const Body* body) {
    return body->inflation.law != INFLATE_GAS || body->inflation.volume > 0;
}

/// The part of dv that is not too far.
static double first_part(const Body* body, const Room* room, double h) {
    const double most = (double)vectors()->most(room->change, body->count);
    return fmin(1, farthest * body->size / (h * sqrt(most)));
}

/// Take dv, or as much of it as makes things better, where they are worse than `rounding`. Returns
/// the residual's new size, or less than 0 where no part of dv does.
static double take(Body* body, Room* room, double before, double rounding, double h) {
    double potential_before = NAN, taken = 0, part = first_part(body, room, h);
    for (int halving = 0; halving < HALVINGS_MOST; halving++, part /= 2) {
        if (halving == 1) { // the first part was not good: what was it worth before?
            go(body, room, -taken, h);
            potential_before = potential(body, room, h);
            taken = 0;
        }
        go(body, room, part - taken, h);
        taken = part;
        const double after = residual(body, room, h);
        if (!has_room(body))
            continue;
        if (after <= fmax(before, rounding) ||
            (halving > 0 && potential(body, room, h) < potential_before))
            return after;
    }
    return -1;
}

static void put_back(Body* body, const Room* room) {
    memcpy(body->x, room->x, (size_t)body->count * sizeof *body->x);
    memcpy(body->v, room->v, (size_t)body->count * sizeof *body->v);
}

/// dv by the full tangent, or where that is not positive by the part of it that is, which also
/// leads downhill.
static void find_change(Body* body, Room* room, double h, Effort* effort) {
    const int before = effort->products;
    if (!solve_linear(body, room, h, effort)) {
        ready(body, room, h, true);
        solve_linear(body, room, h, effort);
        room->levels_h = 0;
        return;
    }
    const int products = effort->products - before;
    if (room->fresh == 0)
        room->fresh = products;
    else if (products > stale_share * room->fresh + stale_more)
        room->levels_h = 0;
}

static bool solve(Body* body, Room* room, double size, double h, Effort* effort) {
    const Solver* solver = &room->solver;
    const bool counted = solver->tolerance < 0;
    const double scale = fmax(size, measure_of(body, h));
    double enough = counted ? -1 : solver->tolerance * scale;
    while (effort->iterations < solver->iterations && size > enough) {
        const double rounding = ready(body, room, h, false);
        if (!counted)
            enough = fmax(enough, rounding);
        if (size <= enough)
            break;
        find_change(body, room, h, effort);
        size = take(body, room, size, rounding, h);
        effort->iterations++;
        if (!(size >= 0))
            return false;
    }
    effort->residual = scale > 0 ? size / scale : 0;
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

static bool kick(Body* body, void* self, double h, Effort* effort) {
    Room* room = self;
    room->holds = holds_some(body);
    *effort = (Effort){0};
    memcpy(room->x, body->x, (size_t)body->count * sizeof *room->x);
    memset(room->change, 0, (size_t)body->count * sizeof *room->change);
    if (room->solver.start == START_REST)
        rest(body);
    memcpy(room->v, body->v, (size_t)body->count * sizeof *room->v);
    go(body, room, 0, h);
    double size = residual(body, room, h);
    if (!has_room(body)) { // it would turn inside out by itself: begin where it is
        rest(body);
        go(body, room, 0, h);
        size = residual(body, room, h);
    }

    const bool solved = solve(body, room, size, h, effort);
    if (!solved)
        put_back(body, room);
    else
        memcpy(body->x, room->x, (size_t)body->count * sizeof *body->x); // the drift is to come
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
    .kick = kick,
    .drift = body_drift,
};
