#include "contact/skins/skin_motion.h"

#include "contact/contacts.h"

/// [REAL_EPSILON of the largest coordinate] what rounding adds to a displacement: half of one for each
/// of its sum, h, and h v, along three axes
static const double roundings = 4;

/// The middle of a box of vectors, and half its diagonal: none is farther from the middle.
static double middle_of(const Extent* extent, double4* middle) {
    const double4 low = to_double4(extent->low), high = to_double4(extent->high);
    *middle = 0.5 * (low + high);
    return 0.5 * dlength(high - low);
}

/// Lane by lane, without a branch: the lower, b where one is not a number.
static real4 lower(real4 a, real4 b) {
    const __typeof__(a < b) less = a < b;
    return (real4)((less & (__typeof__(less))a) | (~less & (__typeof__(less))b));
}

static real4 higher(real4 a, real4 b) {
    const __typeof__(a > b) more = a > b;
    return (real4)((more & (__typeof__(more))a) | (~more & (__typeof__(more))b));
}

static void widen(Extent* extent, real4 a) {
    extent->low = lower(a, extent->low);
    extent->high = higher(a, extent->high);
}

/// How much longer a box has become along each axis, less 1.
static real4 stretch_of(const Extent* now, const Extent* before) {
    real4 stretch = {0, 0, 0, 0};
    for (int k = 0; k < 3; k++) {
        const real length = before->high[k] - before->low[k];
        if (length > 0)
            stretch[k] = (now->high[k] - now->low[k]) / length - 1;
    }
    return stretch;
}

/// Any stretch gives a bound; that of the boxes a good one.
static SkinMotion motion_of(const TouchingSkin* skin, const Body* body, double ahead) {
    const real4* from = skin->reference;
    const real h = body->asleep ? 0 : (real)ahead;
    Extent now, before = {from[0], from[0]};
    now.low = now.high = body->x[0] + h * body->v[0];
    for (int i = 1; i < body->count; i++) {
        widen(&now, body->x[i] + h * body->v[i]);
        widen(&before, from[i]);
    }
    const real4 stretch = stretch_of(&now, &before);
    const real4 first = body->x[0] + h * body->v[0] - from[0],
                first_rest = first - stretch * from[0];
    Extent way = {first, first}, rest = {first_rest, first_rest};
    for (int i = 1; i < body->count; i++) {
        const real4 d = body->x[i] + h * body->v[i] - from[i];
        widen(&way, d);
        widen(&rest, d - stretch * from[i]);
    }
    SkinMotion motion = skin->reference_motion;
    double4 middle;
    motion.residual += middle_of(&rest, &middle);
    motion.path += middle_of(&way, &middle);
    motion.shift += middle;
    motion.stretch *= fmin(1, 1 + (double)real_min(real_min(stretch[0], stretch[1]), stretch[2]));
    return motion;
}

const SkinMotion* skin_motion_measure(Contacts* contacts, int b, double ahead) {
    TouchingSkin* skin = &contacts->skin_pairs.skin[b];
    if (!(skin->ahead == ahead)) {
        skin->motion = motion_of(skin, contacts->skin[b].body, ahead);
        skin->ahead = ahead;
    }
    return &skin->motion;
}

void skin_motion_measure_velocities(Contacts* contacts) {
    for (int b = 0; b < contacts->skin_count; b++) {
        const Body* body = contacts->skin[b].body;
        TouchingSkin* skin = &contacts->skin_pairs.skin[b];
        const Extent extent = body->asleep ? (Extent){{0}, {0}} : extent_of(body->v, body->count);
        skin->spread = middle_of(&extent, &skin->velocity);
    }
}

double skin_motion_relative(const Contacts* contacts, int a, int b, double h) {
    const TouchingSkin *p = &contacts->skin_pairs.skin[a], *q = &contacts->skin_pairs.skin[b];
    const double speed = dlength(p->velocity - q->velocity) + p->spread + q->spread;
    if (!(speed > 0)) // none of them moves
        return p->spread + q->spread;
    return h * speed + roundings * REAL_EPSILON * (p->coordinate_max + q->coordinate_max);
}

real4 skin_motion_end(const Contacts* contacts, int b, int i, double h) {
    const Body* body = contacts->skin[b].body;
    if (body->asleep)
        return body->x[i];
    const TouchingSkin* skin = &contacts->skin_pairs.skin[b];
    return skin->has_ends ? skin->end[i] : body->x[i] + (real)h * body->v[i];
}

void skin_motion_drifted(Contacts* contacts, int b, double h) {
    TouchingSkin* skin = &contacts->skin_pairs.skin[b];
    skin->coordinate_max += h * (dlength(skin->velocity) + skin->spread);
    skin->ahead = NAN;
}
