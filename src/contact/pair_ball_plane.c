#include "contact/pair.h"

/// Bullet solves a hit at the start of the substep in which it happens: a short substep keeps the
/// time of the hit.
static double safe_step(Contacts* contacts, int ball, double h, double safe) {
    const Sphere* a = &contacts->sphere[ball];
    const double radius = (double)a->radius;
    for (int k = 0; k < contacts->plane_count; k++) {
        const Plane* plane = &contacts->plane[k];
        const double gap = ddot(plane->normal, to_double4(a->x) - plane->point) - radius;
        const double speed = fabs(ddot(plane->normal, to_double4(a->v))) + contacts->gravity * h;
        safe = pair_safe_time(safe, gap, radius, speed);
    }
    return safe;
}

const PairRow pair_ball_plane = {
    .name = "ball-plane",
    .about = "a ball and the floor or a wall; Bullet solves it",
    .safe_step = safe_step,
};
