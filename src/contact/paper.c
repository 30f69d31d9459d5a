#include "contact/paper.h"

static const real penalty = 50; ///< [1] force on the ball per particle and k_normal

real4 paper_push(const Sphere* sphere, Body* body) {
    const real each = penalty * (real)body->inflation.amount;
    real4 force = {0, 0, 0, 0};
    for (int i = 0; i < body->count; i++) {
        const real4 away = body->x[i] - sphere->x;
        const real distance = length(away);
        if (distance >= sphere->radius || distance <= 0 || body->inverse_mass[i] <= 0)
            continue;
        const real4 out = away / distance;
        body->x[i] = sphere->x + sphere->radius * out;
        force -= each * out;
    }
    return force;
}
