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

typedef struct Room {
    Solver solver;
    Predict predict;
    Factor* factor;
    double4* start; ///< [count] u* [m]
    double4* u;     ///< [count] displacement of the step [m]
    double4* left;  ///< [count] r without the gas's push [kg m]
    double4* swell; ///< [count] z; NULL where there is no gas [m^2/kg]
    double weight;  ///< g . z [m^4/kg]
} Room;

static const char* refuses(const Body* body) {
    if (body->springs.count > 0 && body->springs.law != LAW_HOOKE)
        return "takes springs of Hooke's law only";
    return predict_refuses(body);
}

static void* open(Body* body, const Solver* solver) {
    Room* room = new_array(Room, 1);
    room->solver = *solver;
    if (room->solver.iterations == 0)
        room->solver.iterations = ITERATIONS;
    predict_open(&room->predict, body);
    room->factor = factor_open(body);
    room->start = new_array(double4, body->count);
    room->u = new_array(double4, body->count);
    room->left = new_array(double4, body->count);
    if (body->inflation.law == INFLATE_GAS)
        room->swell = new_array(double4, body->count);
    return room;
}

static void close(void* self) {
    Room* room = self;
    if (!room)
        return;
    predict_close(&room->predict);
    factor_close(room->factor);
    free(room->start);
    free(room->u);
    free(room->left);
    free(room->swell);
    free(room);
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
static double residual(const Body* body, Room* room, double h, double pressure) {
    for (int i = 0; i < body->count; i++)
        room->left[i] =
            ((double)body->mass[i] + h * body_drag(body, i)) * (room->start[i] - room->u[i]);
    pull_springs(body, h * h, room->u, room->left);

    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        if (body->inverse_mass[i] <= 0)
            room->left[i] = (double4){0, 0, 0, 0};
        double4 all = room->left[i];
        if (room->swell && body->inverse_mass[i] > 0)
            all += h * h * pressure * to_double4(body->inflation.gradient[i]);
        sum += (double)room->predict.weight[i] * ddot(all, all);
    }
    return sqrt(sum);
}

/// out = A^-1 right
static bool solve(Room* room, const double4* right, double4* out, int count) {
    double* b = factor_right(room->factor);
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            b[c * count + i] = right[i][c];
    const double* x = factor_solve(room->factor);
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
static bool ready_gas(const Body* body, Room* room) {
    for (int i = 0; i < body->count; i++)
        room->left[i] = body->inverse_mass[i] > 0 ? to_double4(body->inflation.gradient[i])
                                                  : (double4){0, 0, 0, 0};
    if (!solve(room, room->left, room->swell, body->count))
        return false;
    room->weight = along_gradient(body, room->swell);
    return true;
}

/// Volume at u, from the state's own precision.
static double volume_at(const Body* body, Room* room) {
    for (int i = 0; i < body->count; i++)
        room->predict.u[i] = to_real4(room->u[i]);
    return predict_volume(&room->predict, body);
}

/// u' = u + A^-1 (r + h^2 p(V') g)
static bool improve(Body* body, Room* room, double h2) {
    double4* change = room->left;
    if (!solve(room, room->left, change, body->count))
        return false;
    double push = 0;
    if (room->swell) {
        const Inflation* gas = &body->inflation;
        const double ahead = gas->volume + along_gradient(body, change);
        push = h2 * predict_pressure(gas, ahead, room->weight, h2, 0);
    }
    for (int i = 0; i < body->count; i++)
        room->u[i] += room->swell ? change[i] + push * room->swell[i] : change[i];
    return true;
}

static bool kick(Body* body, void* self, double h, Effort* effort) {
    Room* room = self;
    const Solver* solver = &room->solver;
    *effort = (Effort){0};
    if (!factor_take(room->factor, body, h, &effort->factored))
        return false;
    predict_begin(&room->predict, body, h);
    for (int i = 0; i < body->count; i++)
        room->u[i] = room->start[i] = to_double4(room->predict.u[i]);
    if (room->swell && !ready_gas(body, room))
        return false;

    for (double first = 0;; effort->iterations++) {
        double pressure = 0;
        if (room->swell) {
            body->inflation.volume = volume_at(body, room);
            pressure = gas_pressure(&body->inflation, body->inflation.volume);
        }
        const double size = residual(body, room, h, pressure);
        first = fmax(first, size);
        effort->residual = first > 0 ? size / first : 0;
        if (effort->iterations == solver->iterations || effort->residual <= solver->tolerance)
            break;
        if (!improve(body, room, h * h))
            return false;
    }
    for (int i = 0; i < body->count; i++)
        room->predict.u[i] = to_real4(room->u[i]);
    predict_end(&room->predict, body, h);
    return true;
}

const Method method_projective = {
    .name = "projective",
    .about = "local and global steps on a factored matrix, order 1, any step; Hooke's law",
    .implicit = true,
    .iterates = true,
    .can_fail = true,
    .refuses = refuses,
    .open = open,
    .close = close,
    .kick = kick,
    .drift = body_drift,
};
