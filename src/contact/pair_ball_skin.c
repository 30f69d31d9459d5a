#include <math.h>

#include "contact/ball_triangle.h"
#include "contact/broad_phase.h"
#include "contact/ccd.h"
#include "contact/pair.h"
#include "contact/shared_feature.h"

static const double min_drift = 0.05; ///< [radii] that a drift may always close
static const double core = 0.25;      ///< [radii] around the centre that no triangle may enter
static const double slack = 0.05;     ///< [radii] added to the distance that speeds can close
static const real bounce_kicks = 4;   ///< [kicks] slowest bounce: it lasts 8 substeps

/// Off a thing a ball bounces as off a plane. Where the bounce would begin too high, it comes down to the
/// thing in drifts that surely end before the hit. At most h [s].
static double time_to_bounce(const Contacts* contacts, const Sphere* sphere, double gap,
                             double speed, double h) {
    const double e = (double)sphere->restitution;
    const double t = gap > 0 ? pair_before_hit * gap / speed : 0;
    const bool counts = e > 0 && pair_bounces_early(contacts->gravity, e, gap, speed * speed) &&
                        speed > pair_min_bounce * fmax(t, contacts->drift);
    return t > pair_min_drift * h && t < h && counts ? t : h;
}

/// Looks at the triangles only where the boxes do not rule the skin out.
static double safe_step_to_skin(Contacts* contacts, int b, Sphere* sphere, double h) {
    ContactSkin* skin = &contacts->skin[b];
    const double radius = (double)sphere->radius;
    const double speed = (double)length(sphere->v) +
                         contacts->gravity * contacts_fall_time(contacts, h) + skin->fastest;
    const double reach = radius + speed * h;
    const bool bounces = contacts_thing(contacts, b) && sphere->restitution > 0 &&
                         speed > pair_min_bounce * contacts->drift;
    if ((speed * h <= pair_max_overlap * radius && !bounces) ||
        broad_phase_box_distance(skin, to_double4(sphere->x)) >= reach)
        return h;
    broad_phase_refit(skin);
    if (broad_phase_box_distance(skin, to_double4(sphere->x)) >= reach)
        return h;
    const double gap = broad_phase_distance(contacts, skin, sphere, reach) - radius;
    h = pair_safe_time(h, gap, radius, speed);
    return bounces ? time_to_bounce(contacts, sphere, gap, speed, h) : h;
}

/// How far the skin's particles may have come since the last refit. Corrections after the drift
/// changed speeds: the larger of both bounds the motion.
static void bound_motion(const Contacts* contacts, ContactSkin* skin) {
    const double fastest = broad_phase_max_speed(skin->body);
    skin->path_max += contacts->drift * fmax(skin->fastest, fastest);
    skin->fastest = fastest;
}

static double safe_step(Contacts* contacts, double h) {
    if (contacts->sphere_count == 0)
        return h;
    for (int b = 0; b < contacts->skin_count; b++) {
        bound_motion(contacts, &contacts->skin[b]);
        for (int s = 0; s < contacts->sphere_count; s++)
            h = safe_step_to_skin(contacts, b, &contacts->sphere[s], h);
    }
    return h;
}

/// Largest speed of a triangle's corners relative to the ball [m/s].
static double max_relative_speed(const Contact* c) {
    real fastest = 0;
    for (int k = 1; k < c->node_count; k++) {
        const real4 v = *c->node[0].velocity - *c->node[k].velocity;
        fastest = real_max(fastest, dot(v, v));
    }
    return sqrt((double)fastest);
}

/// Approach speed that the kick of this substep and the ball's weight alone gave: a contact at rest
/// has it, too.
static real kick_speed(const Contact* c, const ContactSkin* skin, bool skins_kicked, real fall) {
    real4 kick = {0, fall, 0, 0};
    for (int k = 0; skins_kicked && k < 3; k++) {
        const int i = skin->body->mesh->triangle[c->feature][k];
        kick -= c->node[k + 1].weight * (skin->body->v[i] - skin->before[i]);
    }
    return real_max(0, dot(c->normal, kick));
}

/// A thing does not give way: a ball bounces off it as off a plane.
static void set_thing(const Contacts* contacts, Contact* contact, double h) {
    const double closing = -(double)dot(contact->normal, contact_relative_velocity(contact));
    contact->rigid = true;
    contact->first = pair_bounces((double)contact->gap, closing, h, fmax(h, contacts->drift));
    contact->fall_speed = (real)(contacts->gravity * (double)contact->normal[1] * h / 2);
}

/// Whether no neighbor of the contact's triangle, of a thing, is nearer to the ball.
static bool is_nearest(const Thing* thing, const Contact* contact) {
    const ContactNode* corner = contact->node + 1;
    const double weight[3] = {-(double)corner[0].weight, -(double)corner[1].weight,
                              -(double)corner[2].weight};
    return thing_is_nearest(thing, (int)contact->feature, weight,
                            to_double4(*contact->node[0].position));
}

/// Contacts of the near triangles of one pair. Those that may touch in a drift of length h are for
/// the solver, the others for the limits of the drift.
static void gather_pair(Contacts* contacts, int row, int s, int b, double h) {
    const int number = s * contacts->skin_count + b;
    ContactPair* pair = &contacts->pair[number];
    ContactSkin* skin = &contacts->skin[b];
    const Thing* thing = contacts_thing(contacts, b);
    Sphere* sphere = &contacts->sphere[s];
    const double radius = (double)sphere->radius;
    const double speed = (double)length(sphere->v) + skin->fastest;
    const double reach = (1 + slack) * radius + 2 * speed * h;
    const real fall = (real)(fmax(h, contacts->drift) * contacts->gravity);
    bool touching = false;
    pair->searched = fmax(reach, broad_phase_box_distance(skin, to_double4(sphere->x)));
    const int count =
        pair->searched <= reach ? broad_phase_triangles(contacts, skin, sphere, reach) : 0;
    for (int k = 0; k < count; k++) {
        Contact* contact = pair_next(contacts);
        ball_triangle_contact(contact, sphere, skin->body, contacts->candidate[k],
                              (real)pair->side);
        contact->side[0] = s;
        contact->side[1] = contacts->sphere_count + b;
        contact->row = row;
        contact->pair = number;
        contact->first = !pair->touching;
        touching |= contact->gap <= (real)1e-3 * sphere->radius;
        const double closed = 1.5 * max_relative_speed(contact) * h + slack * radius;
        const bool may_touch = (double)contact->gap <= closed &&
                               shared_feature_owned(contact, skin->owners) &&
                               (!thing || is_nearest(thing, contact));
        if (may_touch && thing)
            set_thing(contacts, contact, h);
        else if (may_touch)
            contact->min_bounce_speed =
                bounce_kicks * kick_speed(contact, skin, contacts->skins_kicked, fall);
        if (may_touch) {
            contact_set_masses(contact);
            contacts_wake(contacts, b, NONE);
        }
        pair_keep(contacts, may_touch, h);
    }
    pair->touching = touching;
}

static void gather(Contacts* contacts, int row, double h) {
    if (contacts->law == CONTACT_PAPER) // its penalty acts after the drift
        return;
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int b = 0; b < contacts->skin_count; b++)
            gather_pair(contacts, row, s, b, h);
}

/// The solve may have made things faster than they were when the near triangles were gathered: how
/// much of h may be drifted so that no triangle that was not gathered enters the core of a ball.
static double limit_by_unsearched(Contacts* contacts, double h) {
    for (int b = 0; b < contacts->skin_count; b++)
        contacts->skin[b].fastest = broad_phase_max_speed(contacts->skin[b].body);
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int b = 0; b < contacts->skin_count; b++) {
            Sphere* sphere = &contacts->sphere[s];
            const double searched = contacts->pair[s * contacts->skin_count + b].searched;
            const double speed = (double)length(sphere->v) + contacts->skin[b].fastest;
            const double path = speed * h + core * (double)sphere->radius;
            if (path <= searched)
                continue;
            const double distance =
                broad_phase_distance(contacts, &contacts->skin[b], sphere, path);
            h = fmin(h, (fmax(searched, distance) - core * (double)sphere->radius) / speed);
        }
    return h;
}

/// How much of h may be drifted so that no triangle of the list enters the core of a ball.
static double limit_by(const Contact* list, int count, double h) {
    for (int k = 0; k < count; k++) {
        const Contact* c = &list[k];
        if (!pair_has_triangle(c))
            continue;
        const double radius = (double)c->size;
        const double closable = fmax(min_drift * radius, (double)c->gap + (1 - core) * radius);
        const double speed = max_relative_speed(c);
        if (speed * h > closable)
            h = closable / speed;
    }
    return h;
}

static double limit_drift(Contacts* contacts, double h) {
    if (contacts->sphere_count == 0 || contacts->law == CONTACT_PAPER)
        return h;
    h = limit_by(contacts->contact, contacts->contact_count, h);
    h = limit_by(contacts->near, contacts->near_count, h);
    h = ccd_stop(contacts->contact, contacts->contact_count, contacts->near, contacts->near_count,
                 h);
    return limit_by_unsearched(contacts, h);
}

static void count_passes_of(Contacts* contacts, const Contact* list, int count, double h) {
    for (int k = 0; k < count; k++) {
        const Contact* c = &list[k];
        if (!pair_has_triangle(c) || !ccd_passes_through(c, h))
            continue;
        ContactPair* pair = &contacts->pair[c->pair];
        pair->present_side = -pair->present_side;
        if (pair->present_side != pair->side)
            contacts->pass_throughs++;
    }
}

static void count_passes(Contacts* contacts, double h) {
    count_passes_of(contacts, contacts->contact, contacts->contact_count, h);
    count_passes_of(contacts, contacts->near, contacts->near_count, h);
}

const PairRow pair_ball_skin = {
    .name = "ball-skin",
    .about = "a ball and the nearest points of a skin's triangles",
    .safe_step = safe_step,
    .gather = gather,
    .limit_drift = limit_drift,
    .count_passes = count_passes,
};
