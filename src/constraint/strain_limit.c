#include "constraint/strain_limit.h"

#include <stdlib.h>

#include "base/memory.h"

void strain_limit_switch(StrainLimit* correct, Body* body, bool on) {
    correct->on = on && body->springs.count > 0;
    correct->corrected = 0;
    if (correct->on && !correct->ahead)
        correct->ahead = new_array(real4, body->count);
    for (int s = 0; !correct->on && s < body->springs.count; s++)
        body_set_stiffness(body, s, body->springs.stiffness[s]);
}

/// Whether spring s is surely within `most` times its rest length, without a square root: most are, and
/// 40 % of a corrected crowd's time went to their roots. What rounding leaves open is not.
static inline bool is_short(const Springs* springs, const real4* x, int s, real most) {
    const real4 d = x[springs->end[s][1]] - x[springs->end[s][0]];
    const real limit = most * springs->rest[s];
    return dot(d, d) < (1 - 16 * REAL_EPSILON) * (limit * limit);
}

/// Move the ends of spring s together to at most `most` times its rest length, each by its share of
/// the inverse masses: half each, or all at the free end. What it is longer now may be kept in part.
/// True if it was longer.
static bool shorten(const Body* body, real4* x, int s, real most, real kept) {
    const int i = body->springs.end[s][0], j = body->springs.end[s][1];
    const real4 d = x[j] - x[i];
    const real now = length(d);
    real over = now - most * body->springs.rest[s];
    if (kept > 0)
        over -= kept * real_max(0, length(body->x[j] - body->x[i]) - most * body->springs.rest[s]);
    const bool move_i = body->inverse_mass[i] > 0, move_j = body->inverse_mass[j] > 0;
    if (over <= 0 || !(move_i || move_j))
        return false;

    const real4 pull = (over / (now * (real)(move_i + move_j))) * d;
    if (move_i)
        x[i] += pull;
    if (move_j)
        x[j] -= pull;
    return true;
}

/// One sequential pass, kind after kind; springs that a later one lengthens are not visited again.
static void shorten_all(StrainLimit* correct, Body* body, real kept) {
    Springs* springs = &body->springs;
    correct->corrected = 0;
    for (int kind = 0; kind < SPRING_KINDS; kind++) {
        if (correct->threshold[kind] <= 0)
            continue;
        const real most = (real)(1 + correct->threshold[kind]);
        for (int s = springs->from[kind]; s < springs->from[kind + 1]; s++) {
            const bool was_long = !is_short(springs, correct->ahead, s, most) &&
                                  shorten(body, correct->ahead, s, most, kept);
            correct->corrected += was_long;
            const real acts = was_long && correct->tarantino ? 0 : springs->stiffness[s];
            if (acts != springs->active[s])
                body_set_stiffness(body, s, acts);
        }
    }
}

void strain_limit_velocity(StrainLimit* correct, Body* body, double step, double whole) {
    if (!correct->on)
        return;
    const real h = (real)step;
    for (int i = 0; i < body->count; i++)
        correct->ahead[i] = body->x[i] + h * body->v[i];

    shorten_all(correct, body, (real)fmax(0, 1 - step / whole));

    // a corrected particle gets the velocity of its actual motion; any other keeps its velocity,
    // since a difference of positions would only add their rounding
    for (int i = 0; i < body->count; i++) {
        const real4 moved = correct->ahead[i] - (body->x[i] + h * body->v[i]);
        if (correct->phantom)
            body->x[i] += moved;
        else if (dot(moved, moved) > 0)
            body->v[i] = (correct->ahead[i] - body->x[i]) / h;
    }
}

void strain_limit_free(StrainLimit* correct) {
    free(correct->ahead);
    *correct = (StrainLimit){0};
}
