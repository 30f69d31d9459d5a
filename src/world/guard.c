#include "world/guard.h"

double guard_bound(const Method* method, const System* system, int* body) {
    double smallest = INFINITY;
    *body = 0;
    for (int b = 0; b < system->body_count; b++) {
        if (system->body[b]->asleep)
            continue;
        const double bound = method_bound(method, system->body[b]);
        if (bound < smallest) {
            smallest = bound;
            *body = b;
        }
    }
    return smallest;
}

GuardVerdict guard_update(StepGuard* guard, const Method* method, const System* system, double step,
                          int* body) {
    guard->changed = false;
    *body = 0;
    if (guard->mode == GUARD_OFF)
        return VERDICT_GOOD;

    guard->bound = guard_bound(method, system, body);
    if (guard->bound <= 0)
        return VERDICT_NEVER_STABLE;
    const double parts = ceil(step / guard->bound);
    if (guard->mode == GUARD_STOP && parts > 1)
        return VERDICT_TOO_LONG;
    if (!(parts <= SUBSTEPS_MAX))
        return VERDICT_TOO_MANY;
    const int before = guard->substeps;
    guard->substeps = parts > 1 ? (int)parts : 1;
    return (int)parts > before ? VERDICT_SPLIT : VERDICT_GOOD;
}
