/// Strings: nothing up to the free length L, then E = k (d - L)^2 / 2 with d the distance from
/// particle to anchor, so the tension k (d - L) starts from zero and does not chatter.
#include "force/force.h"
#include "force/strings.h"

static bool present(const Body* body) {
    return body->string_count > 0;
}

/// From the particle to the anchor. [m]
static real distance(const Body* body, const String* string) {
    return length(body->x[string->particle] - string->anchor);
}

/// Length over the free length [m], 0 while slack.
static real excess(const Body* body, const String* string) {
    return real_max(distance(body, string) - string->free_length, 0);
}

void string_reach(const Body* body, String* string) {
    string->free_length =
        string_tied_length(string->free_length, string->first_stretch, distance(body, string));
}

double string_tension(const Body* body, int string) {
    const String* s = &body->string[string];
    return (double)(s->stiffness * excess(body, s));
}

static void add(Body* body) {
    for (int k = 0; k < body->string_count; k++) {
        const String* s = &body->string[k];
        const real over = excess(body, s);
        if (over <= 0)
            continue;
        const real4 d = s->anchor - body->x[s->particle];
        body->f[s->particle] += (s->stiffness * over / length(d)) * d;
    }
}

static double energy(const Body* body) {
    double sum = 0;
    for (int k = 0; k < body->string_count; k++) {
        const double over = (double)excess(body, &body->string[k]);
        sum += 0.5 * (double)body->string[k].stiffness * over * over;
    }
    return sum;
}

/// Several strings at one particle add up, so the sum over all bounds the largest.
static double bound(const Body* body) {
    double sum = 0;
    for (int k = 0; k < body->string_count; k++)
        sum += (double)body->string[k].stiffness *
               (double)body->inverse_mass[body->string[k].particle];
    return sum;
}

/// A taut string has the tangent of a spring: k along it, tension / length across; a slack one has
/// none.
static void assemble(const Body* body, double factor, bool project, const int* block_at,
                     BlockMatrix* matrix) {
    (void)project, (void)block_at; // a string only pulls, so its tangent is positive semidefinite
    for (int k = 0; k < body->string_count; k++) {
        const String* s = &body->string[k];
        const real over = excess(body, s);
        if (over <= 0)
            continue;
        const real4 span = body->x[s->particle] - s->anchor;
        const real now = length(span), along = (real)factor * s->stiffness,
                   across = along * over / now;
        const real4 n = span / now;
        Block* block = block_matrix_diagonal(matrix, s->particle);
        for (int c = 0; c < 3; c++) {
            block->column[c] += ((along - across) * n[c]) * n;
            block->column[c][c] += across;
        }
    }
}

const Force force_strings = {
    .name = "strings",
    .about = "tethers, stiffness times what exceeds the free length",
    .present = present,
    .add = add,
    .energy = energy,
    .bound = bound,
    .assemble = assemble,
    .elastic = true,
    .external = true,
};
