#include "contact/pair.h"

static double gap_of(const Plane* plane, const Sphere* ball) {
    return ddot(plane->normal, to_double4(ball->x) - plane->point) - (double)ball->radius;
}

/// A ball bounces at the start of the substep in which it hits: a short substep keeps the time of
/// the hit.
static double safe_step(Contacts* contacts, double h) {
    double safe = h;
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int k = 0; k < contacts->plane_count; k++) {
            const Sphere* ball = &contacts->sphere[s];
            const Plane* plane = &contacts->plane[k];
            const double speed = fabs(ddot(plane->normal, to_double4(ball->v)));
            safe = pair_safe_time(safe, gap_of(plane, ball), (double)ball->radius,
                                  speed + contacts->gravity * h);
        }
    return safe;
}

static void gather_pair(Contacts* contacts, int row, int s, int k, double h) {
    Sphere* ball = &contacts->sphere[s];
    const Plane* plane = &contacts->plane[k];
    const double gap = gap_of(plane, ball), closing = -ddot(plane->normal, to_double4(ball->v));
    if (!(gap <= fmax(pair_touching * (double)ball->radius, closing * h)))
        return;
    Contact* contact = pair_next(contacts);
    *contact = (Contact){.node_count = 1,
                         .lever_count = 1,
                         .normal = to_real4(plane->normal),
                         .gap = (real)gap,
                         .size = ball->radius,
                         .friction = ball->friction,
                         .restitution = ball->restitution,
                         .first = pair_bounces(gap, closing, h),
                         .rigid = true,
                         .side = {s, NONE},
                         .row = row,
                         .pair = s,
                         .feature = k};
    pair_set_ball(contact, 0, ball, 1, ball->radius);
    contact_set_masses(contact);
    pair_keep(contacts, true, h);
}

static void gather(Contacts* contacts, int row, double h) {
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int k = 0; k < contacts->plane_count; k++)
            gather_pair(contacts, row, s, k, h);
}

/// A ball that another contact has pushed toward a plane.
static double limit_drift(Contacts* contacts, double h) {
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int k = 0; k < contacts->plane_count; k++) {
            const Sphere* ball = &contacts->sphere[s];
            const Plane* plane = &contacts->plane[k];
            h = pair_safe_time(h, gap_of(plane, ball), (double)ball->radius,
                               -ddot(plane->normal, to_double4(ball->v)));
        }
    return h;
}

const PairRow pair_ball_plane = {
    .name = "ball-plane",
    .about = "a ball and the floor or a wall",
    .safe_step = safe_step,
    .gather = gather,
    .limit_drift = limit_drift,
};
