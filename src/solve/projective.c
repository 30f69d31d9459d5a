/// Projective dynamics: backward Euler by turns of a local and a global step, with one matrix that
/// is factored before.
///
///     local     d_s, the spring's vector where it is now, at its rest length
///     global    A u' = (M + h C) u* + h^2 sum of k (d_s - e_s) over the springs, e_s their vectors
///               at x, u* what is not constraint (solve/predict.h), A = M + h C + h^2 L (factor.h)
///     v' = u / h
///
/// The global step is written as u' = u + A^-1 r, r what is left of backward Euler's equation at u:
/// the same for Hooke's law, and it says how far it has come. A string is a spring to a fixed
/// point, and where it is slack, d_s is where it is. A gas adds h^2 p(V') g, g = dV/dx, which is of
/// rank one: with z = A^-1 g once a step, V' = V + g . A^-1 r + g . z h^2 p(V') is one equation for
/// one number, and Woodbury's formula where p is a straight line. Order 1; never unstable; linear
/// momentum to rounding, angular momentum to order. Where iterations end early the skin lags
/// behind: it turns and swings too slowly. Source: T. Liu, A. Bargteil, J. O'Brien, L. Kavan, Fast
/// simulation of mass-spring systems, 2013.
#include <stdlib.h>

#include "base/memory.h"
#include "solve/factor.h"
#include "solve/method.h"
#include "solve/predict.h"

enum { ITERATIONS = 10 };

typedef struct Workspace {
    Solver solver;
    Predict predict;
    Factor* factor;
    double4* start; ///< [count] u* [m]
    double4* u;     ///< [count] displacement of the step [m]
    double4* left;  ///< [count] r without the gas's push [kg m]
    double4* swell; ///< [count] z; NULL where there is no gas [m^2/kg]
    double weight;  ///< g . z [m^4/kg]
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
    workspace->left = new_array(double4, body->count);
    if (body->inflation.law == INFLATE_GAS)
        workspace->swell = new_array(double4, body->count);
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
    free(workspace->left);
    free(workspace->swell);
    free(workspace);
}

/// h^2 times the pull of a spring with the vector d: h^2 k (d - d at its rest length).
static inline double4 pull_of(double4 d, double rest, double stiff) {
    const double now = dlength(d);
    return now > 0 ? stiff * (1 - rest / now) * d : d;
}

static void pull_springs(const Body* body, double h2, const double4* restrict u,
                         double4* restrict left) {
    const Springs* springs = &body->springs;
    const real4* x = body->x;
    for (int s = 0; s < springs->count; s++) {
        const int i = springs->end[s][0], j = springs->end[s][1];
        const double4 d = to_double4(x[j] - x[i]) + (u[j] - u[i]);
        const double4 pull = pull_of(d, (double)springs->rest[s], h2 * (double)springs->active[s]);
        left[i] += pull;
        left[j] -= pull;
    }
    for (int k = 0; k < body->string_count; k++) {
        const String* string = &body->string[k];
        const int i = string->particle;
        const double4 d = to_double4(x[i] - string->anchor) + u[i];
        if (dlength(d) > (double)string->free_length)
            left[i] -= pull_of(d, (double)string->free_length, h2 * (double)string->stiffness);
    }
}

/// r without the gas's push; returns the size of all of r under a pressure, |r|_w.
static double residual(const Body* body, Workspace* workspace, double h, double pressure) {
    for (int i = 0; i < body->count; i++)
        workspace->left[i] = ((double)body->mass[i] + h * body_drag(body, i)) *
                             (workspace->start[i] - workspace->u[i]);
    pull_springs(body, h * h, workspace->u, workspace->left);

    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        if (body->inverse_mass[i] <= 0)
            workspace->left[i] = (double4){0, 0, 0, 0};
        double4 all = workspace->left[i];
        if (workspace->swell && body->inverse_mass[i] > 0)
            all += h * h * pressure * to_double4(body->inflation.gradient[i]);
        sum += (double)workspace->predict.weight[i] * ddot(all, all);
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
static bool ready_gas(const Body* body, Workspace* workspace) {
    for (int i = 0; i < body->count; i++)
        workspace->left[i] = body->inverse_mass[i] > 0 ? to_double4(body->inflation.gradient[i])
                                                       : (double4){0, 0, 0, 0};
    if (!solve(workspace, workspace->left, workspace->swell, body->count))
        return false;
    workspace->weight = along_gradient(body, workspace->swell);
    return true;
}

/// Volume at u, from the state's own precision.
static double volume_at(const Body* body, Workspace* workspace) {
    for (int i = 0; i < body->count; i++)
        workspace->predict.u[i] = to_real4(workspace->u[i]);
    return predict_volume(&workspace->predict, body);
}

/// u' = u + A^-1 (r + h^2 p(V') g)
static bool improve(Body* body, Workspace* workspace, double h2) {
    double4* change = workspace->left;
    if (!solve(workspace, workspace->left, change, body->count))
        return false;
    double push = 0;
    if (workspace->swell) {
        const Inflation* gas = &body->inflation;
        const double ahead = gas->volume + along_gradient(body, change);
        push = h2 * predict_pressure(gas, ahead, workspace->weight, h2, 0);
    }
    for (int i = 0; i < body->count; i++)
        workspace->u[i] += workspace->swell ? change[i] + push * workspace->swell[i] : change[i];
    return true;
}

static bool kick_body(Body* body, void* self, double h, SolveStats* stats) {
    Workspace* workspace = self;
    const Solver* solver = &workspace->solver;
    *stats = (SolveStats){0};
    if (!factor_take(workspace->factor, body, h, &stats->factored))
        return false;
    predict_begin(&workspace->predict, body, h);
    for (int i = 0; i < body->count; i++)
        workspace->u[i] = workspace->start[i] = to_double4(workspace->predict.u[i]);
    if (workspace->swell && !ready_gas(body, workspace))
        return false;

    for (double first = 0;; stats->iterations++) {
        double pressure = 0;
        if (workspace->swell) {
            body->inflation.volume = volume_at(body, workspace);
            pressure = gas_pressure(&body->inflation, body->inflation.volume);
        }
        const double size = residual(body, workspace, h, pressure);
        first = fmax(first, size);
        stats->residual = first > 0 ? size / first : 0;
        if (stats->iterations == solver->iterations || stats->residual <= solver->tolerance)
            break;
        if (!improve(body, workspace, h * h))
            return false;
    }
    for (int i = 0; i < body->count; i++)
        workspace->predict.u[i] = to_real4(workspace->u[i]);
    predict_end(&workspace->predict, body, h);
    return true;
}

const Method method_projective = {
    .name = "projective",
    .about = "local and global steps on a factored matrix, order 1, any step; Hooke's law",
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
