#include "contact/pair.h"

static double gap_of(const Plane* plane, const Sphere* ball) {
    return ddot(plane->normal, to_double4(ball->x) - plane->point) - (double)ball->radius;
}

/// Where the bounce would begin too high, a drift ends just before the hit, the root of
/// gap + w t - g t^2 / 2. At most h [s].
static double time_to_bounce(const Contacts* contacts, const Plane* plane, const Sphere* ball,
                             double gap, double h) {
    const double g = contacts->gravity * plane->normal[1], e = (double)ball->restitution;
    const double since = contacts_fall_time(contacts, 0); // the velocity is that much older
    const double w =
        ddot(plane->normal, to_double4(ball->v)) - (contacts->drift > 0 ? g * since : 0);
    const double impact2 = w * w + 2 * g * gap; // squared speed of the hit
    if (!(e > 0 && gap > 0 && impact2 > 0))
        return h;
    const double t = pair_before_hit * 2 * gap / (sqrt(impact2) - w);
    const bool counts = pair_bounces_early(g, e, gap, impact2) &&
                        impact2 > pow(pair_min_bounce * fmax(t, contacts->drift), 2);
    return t > pair_min_drift * h && t < h && counts ? t : h;
}

static double safe_step(Contacts* contacts, double h) {
    double safe = h;
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int k = 0; k < contacts->plane_count; k++) {
            const Sphere* ball = &contacts->sphere[s];
            const Plane* plane = &contacts->plane[k];
            const double speed = fabs(ddot(plane->normal, to_double4(ball->v)));
            safe = pair_safe_time(safe, gap_of(plane, ball), (double)ball->radius,
                                  speed + contacts->gravity * contacts_fall_time(contacts, h));
            safe = time_to_bounce(contacts, plane, ball, gap_of(plane, ball), safe);
        }
    return safe;
}

/// A ball behind a plane comes out no faster than its overlap asks for, and so comes to rest there.
static void stop(Contacts* contacts, double h) {
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int k = 0; k < contacts->plane_count; k++) {
            Sphere* ball = &contacts->sphere[s];
            const Plane* plane = &contacts->plane[k];
            const double gap = gap_of(plane, ball);
            if (!(gap < -pair_touching * (double)ball->radius))
                continue;
            const double excess = ddot(plane->normal, to_double4(ball->v)) -
                                  (double)contact_overlap_speed((real)gap, ball->radius, (real)h);
            if (excess > 0)
                ball->v -= to_real4(excess * plane->normal);
        }
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
                         .first = pair_bounces(gap, closing, h, fmax(h, contacts->drift)),
                         .fall_speed = (real)(contacts->gravity * plane->normal[1] * h / 2),
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
    .stop = stop,
    .limit_drift = limit_drift,
};
