#include "contact/pair.h"

/// With the balls of higher number: each pair once.
static double safe_step(Contacts* contacts, int ball, double h, double safe) {
    (void)h;
    const Sphere* a = &contacts->sphere[ball];
    for (int k = ball + 1; k < contacts->sphere_count; k++) {
        const Sphere* b = &contacts->sphere[k];
        const double gap = (double)(length(a->x - b->x) - a->radius - b->radius);
        const double speed = (double)length(a->v - b->v);
        const double radius = fmin((double)a->radius, (double)b->radius);
        safe = pair_safe_time(safe, gap, radius, speed);
    }
    return safe;
}

const PairRow pair_ball_ball = {
    .name = "ball-ball",
    .about = "two balls; Bullet solves it",
    .safe_step = safe_step,
};
