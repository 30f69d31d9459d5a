#include "contact/pair.h"

/// Pairs that may touch within h, where gravity or a contact adds at most `added` to a speed.
static int near(Contacts* contacts, double h, double added, const int (**pair)[2]) {
    return contacts->sphere_count < 2
               ? 0
               : bullet_balls_near(contacts->balls, contacts->sphere, contacts->sphere_count, h,
                                   added * h, pair);
}

/// At most h, and so long that no two balls overlap by more than their share.
static double safe_time(Contacts* contacts, double h, double added) {
    const int(*pair)[2];
    const int count = near(contacts, h, added, &pair);
    double safe = h;
    for (int k = 0; k < count; k++) {
        const Sphere *a = &contacts->sphere[pair[k][0]], *b = &contacts->sphere[pair[k][1]];
        const double gap = (double)(length(a->x - b->x) - a->radius - b->radius);
        safe = pair_safe_time(safe, gap, fmin((double)a->radius, (double)b->radius),
                              (double)length(a->v - b->v));
    }
    return safe;
}

static double safe_step(Contacts* contacts, double h) {
    return safe_time(contacts, h, contacts->gravity * contacts_fall_time(contacts, h));
}

/// The time until |d + t v| = reach, for |d| > reach; INFINITY if never.
static double time_to_touch(double4 d, double4 v, double reach) {
    const double toward = -ddot(d, v), speed2 = ddot(v, v);
    const double excess = ddot(d, d) - reach * reach;
    const double root2 = toward * toward - speed2 * excess;
    return toward > 0 && root2 >= 0 ? excess / (toward + sqrt(root2)) : INFINITY;
}

/// Normal, gap and lever arms of two balls. Touching: at the point between them, so that the pair's
/// angular momentum is kept. Apart: where their straight paths make them touch within h, in the
/// directions of that time. Returns whether they do.
static bool meet(Contact* contact, Sphere* a, Sphere* b, double h, double rest_h) {
    const double4 d = to_double4(a->x) - to_double4(b->x);
    const double4 v = to_double4(a->v) - to_double4(b->v);
    const double reach = (double)a->radius + (double)b->radius;
    const double distance = dlength(d);
    double4 normal = distance > 0 ? d / distance : (double4){0, 1, 0, 0};
    double gap = distance - reach, between = gap;
    if (gap > pair_touching * (double)contact->size) {
        const double t = time_to_touch(d, v, reach);
        if (!(t <= h))
            return false;
        normal = (d + t * v) / reach;
        gap = -ddot(normal, v) * t;
        between = 0;
    }
    const double closing = -ddot(normal, v);
    contact->normal = to_real4(normal);
    contact->gap = (real)gap;
    contact->first = pair_bounces(gap, closing, h, rest_h);
    pair_set_ball(contact, 0, a, 1, (real)((double)a->radius + between / 2));
    pair_set_ball(contact, 1, b, -1, (real)((double)b->radius + between / 2));
    contact_set_masses(contact);
    return true;
}

/// Two balls share the geometric means of their coefficients, so that equal balls have their own.
static void gather(Contacts* contacts, int row, double h) {
    const int(*pair)[2];
    const int count = near(contacts, h, 0, &pair);
    for (int k = 0; k < count; k++) {
        const int first = pair[k][0], second = pair[k][1];
        Sphere *a = &contacts->sphere[first], *b = &contacts->sphere[second];
        Contact* contact = pair_next(contacts);
        *contact = (Contact){.node_count = 2,
                             .lever_count = 2,
                             .size = real_min(a->radius, b->radius),
                             .friction = real_sqrt(a->friction * b->friction),
                             .restitution = real_sqrt(a->restitution * b->restitution),
                             .rigid = true,
                             .side = {first, second},
                             .row = row,
                             .pair = first,
                             .feature = second};
        if (meet(contact, a, b, h, fmax(h, contacts->drift)))
            pair_keep(contacts, true, h);
    }
}

/// Balls that a contact has pushed toward each other.
static double limit_drift(Contacts* contacts, double h) {
    return safe_time(contacts, h, 0);
}

const PairRow pair_ball_ball = {
    .name = "ball-ball",
    .about = "two balls",
    .safe_step = safe_step,
    .gather = gather,
    .limit_drift = limit_drift,
};
