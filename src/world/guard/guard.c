#include "world/guard/guard.h"

enum { REFINEMENT_MAX = 64 }; ///< floor of the energy watch: 1/64 of a stable substep

/// A number of substeps that has to grow grows by this share more, so that it grows seldom. [1]
static const double growth_margin = 0.125;

/// Smallest factor by which the bound is expected to fall from one look to the next. [1]
static const double fall_min = 0.5;

StepGuard guard_new(Guard mode) {
    return (StepGuard){.mode = mode, .substeps = 1, .changed = true, .refinement = 1};
}

double guard_bound(const Method* method, const System* system, int* body) {
    double smallest = INFINITY;
    *body = 0;
    for (int b = 0; b < system->body_count; b++) {
        if (system->body[b]->asleep)
            continue;
        const double bound = method_bound(method, system->body[b]);
        if (!(bound >= smallest)) { // written so that a NaN is the smallest
            smallest = bound;
            *body = b;
        }
    }
    for (int k = 0; k < system->joints.knot_count; k++) {
        const Knot* knot = &system->joints.knot[k];
        const double bound = method_limit(method, knot->w2, 0);
        if (!knot->held && knot->body != NONE && bound < smallest) {
            smallest = bound;
            *body = knot->body;
        }
    }
    return smallest;
}

bool guard_limits_strain(const System* system) {
    for (int b = 0; b < system->body_count; b++)
        if (system->strain_limit[b]->on)
            return true;
    return false;
}

double guard_bound_corrected(const StepGuard* guard, const Method* method, const System* system) {
    int body;
    const bool of_constraints = method->takes != NULL;
    if (guard->mode != GUARD_SPLIT || !method->implicit ||
        !(of_constraints || guard_limits_strain(system)))
        return (double)INFINITY;
    return guard_bound(&method_euler, system, &body);
}

bool guard_due(const StepGuard* guard, long step_count) {
    return guard->changed || step_count % GUARD_INTERVAL == 0 || guard_due_within(guard);
}

bool guard_due_within(const StepGuard* guard) {
    return guard->since_look >= GUARD_INTERVAL;
}

/// Take the number of substeps that a look asks for: more at once, fewer only when HOLD_LOOKS looks
/// have asked for fewer.
static void set_substeps(StepGuard* guard, int wanted) {
    if (wanted >= guard->substeps) {
        const int margin =
            guard->substeps > 1 && wanted > guard->substeps ? (int)(growth_margin * wanted) : 0;
        guard->substeps = wanted + margin < SUBSTEPS_MAX ? wanted + margin : wanted;
        guard->calm_looks = guard->calm_substeps = 0;
        return;
    }
    guard->calm_substeps = wanted > guard->calm_substeps ? wanted : guard->calm_substeps;
    if (++guard->calm_looks < HOLD_LOOKS || guard->made_again)
        return;
    guard->refinement = guard->refinement > 1 ? guard->refinement / 2 : 1;
    guard->substeps = guard->calm_substeps;
    guard->calm_looks = guard->calm_substeps = 0;
}

GuardVerdict guard_update(StepGuard* guard, const Method* method, const System* system, double step,
                          int* body) {
    guard->changed = false;
    guard->since_look = 0;
    *body = 0;
    if (guard->mode == GUARD_OFF)
        return VERDICT_GOOD;

    const double before = guard->bound;
    guard->bound = guard_bound(method, system, body);
    if (guard->bound <= 0)
        return VERDICT_NEVER_STABLE;
    if (guard->mode == GUARD_STOP && step > guard->bound)
        return VERDICT_TOO_LONG;
    if (!(guard->refinement * ceil(step / guard->bound) <= SUBSTEPS_MAX))
        return VERDICT_TOO_MANY;
    const double fall =
        before > 0 && before < INFINITY ? fmax(fmin(guard->bound / before, 1), fall_min) : 1;
    const double wanted =
        fmin(guard->refinement * ceil(step / (guard->bound * fall)), SUBSTEPS_MAX);
    set_substeps(guard, wanted > 1 ? (int)wanted : 1);
    if (guard->substeps < 2 * guard->noticed || guard->substeps == 1)
        return VERDICT_GOOD;
    guard->noticed = guard->substeps;
    return VERDICT_SPLIT;
}

bool guard_refine(StepGuard* guard) {
    if (guard->refinement >= REFINEMENT_MAX || guard->substeps > SUBSTEPS_MAX / 2)
        return false;
    guard->made_again = true;
    guard->refinement *= 2;
    guard->substeps *= 2;
    guard->calm_looks = guard->calm_substeps = 0;
    return true;
}
