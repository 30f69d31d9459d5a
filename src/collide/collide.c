#include "collide/collide.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "collide/cross.h"
#include "collide/feature.h"
#include "collide/near.h"
#include "collide/paper.h"
#include "collide/sweep.h"

const char* const contact_law_name[CONTACT_LAWS] = {"impulse", "paper"};

enum { CONTACTS_FIRST = 1024, SPHERES_FIRST = 16, ROUNDS_WITH_PLANES = 4 };

static const double deep = 0.5;    ///< [radii] a ball may come nearer than touching in a part
static const double least = 0.05;  ///< [radii] that a part may always go
static const double core = 0.25;   ///< [radii] around the centre that no triangle may come near
static const double slack = 0.05;  ///< [radii] contacts are looked for beyond what speeds say
static const real bounces = 4;     ///< [kicks] of approach; a slower bounce is over in eight parts
static const double little = 1e-3; ///< [1] of the energy that the first round moved

void collide_open(Collide* collide, ContactLaw law, double gravity, const Plane* plane,
                  int plane_count, Body* const* body, const real4* const* before, int body_count) {
    *collide = (Collide){
        .law = law,
        .gravity = gravity,
        .plane_count = plane_count,
        .plane = new_array(Plane, plane_count),
        .skin_count = body_count,
        .skin = new_array(CollideSkin, body_count),
    };
    for (int k = 0; k < plane_count; k++)
        collide->plane[k] = plane[k];
    for (int b = 0; b < body_count; b++)
        collide->skin[b] = (CollideSkin){.body = body[b], .before = before[b]};
}

/// What only a scene with balls needs, made at the first of them.
static void begin(Collide* collide) {
    collide->bullet = bullet_open();
    for (int k = 0; k < collide->plane_count; k++) {
        const double4 p = collide->plane[k].point, n = collide->plane[k].normal;
        bullet_add_plane(collide->bullet, (double[]){p[0], p[1], p[2]},
                         (double[]){n[0], n[1], n[2]});
    }
    for (int b = 0; b < collide->skin_count; b++) {
        CollideSkin* skin = &collide->skin[b];
        const Mesh* mesh = skin->body->mesh;
        skin->owners = feature_owners(mesh);
        skin->patches = bullet_skin_open(collide->bullet, (const int(*)[3])mesh->triangle,
                                         mesh->triangle_count, skin->body->x, mesh->point_count);
        skin->fastest = near_fastest(skin->body);
        skin->grown = INFINITY;
    }
    collide->contact_room = CONTACTS_FIRST;
    collide->contact = new_array(Contact, CONTACTS_FIRST);
    collide->triangle = new_array(int, CONTACTS_FIRST);
    collide->warm.push = new_array(Push, CONTACTS_FIRST);
    collide->sphere_room = SPHERES_FIRST;
    collide->sphere = new_array(Sphere, SPHERES_FIRST);
    collide->good = new_array(Sphere, SPHERES_FIRST);
    collide->pair = new_array(CollidePair, SPHERES_FIRST * collide->skin_count);
}

void collide_add(Collide* collide, const Sphere* sphere) {
    if (!collide->bullet)
        begin(collide);
    if (collide->sphere_count == collide->sphere_room) {
        const size_t room = (size_t)collide->sphere_room;
        collide->sphere = near_grown(collide->sphere, room, sizeof(Sphere));
        collide->good = near_grown(collide->good, room, sizeof(Sphere));
        collide->pair =
            near_grown(collide->pair, room * (size_t)collide->skin_count, sizeof(CollidePair));
        collide->sphere_room *= 2;
    }
    const int s = collide->sphere_count++;
    collide->sphere[s] = *sphere;
    for (int b = 0; b < collide->skin_count; b++) {
        const Body* body = collide->skin[b].body;
        const bool inside =
            body->mesh->closed && cross_winding(body->mesh, body->x, to_double4(sphere->x)) > 0.5;
        const int side = inside ? -1 : 1;
        collide->pair[s * collide->skin_count + b] = (CollidePair){.side = side, .now = side};
    }
}

/// What is known of contacts and boxes is no longer so.
static void forget(Collide* collide) {
    collide->contact_count = collide->near_count = collide->warm.count = 0;
    for (int b = 0; b < collide->skin_count; b++)
        collide->skin[b].grown = INFINITY;
}

void collide_clear(Collide* collide) {
    collide->sphere_count = 0;
    forget(collide);
}

/// How long a ball may go before it has to look at a skin again.
static double pace_of(Collide* collide, CollideSkin* skin, Sphere* sphere, double h) {
    const double radius = (double)sphere->radius;
    const double speed = (double)length(sphere->v) + collide->gravity * h + skin->fastest;
    const double reach = radius + speed * h;
    if (speed * h <= deep * radius || near_box(skin, to_double4(sphere->x)) >= reach)
        return h;
    near_refit(skin);
    if (near_box(skin, to_double4(sphere->x)) >= reach)
        return h;
    const double distance = near_distance(collide, skin, sphere, reach);
    return fmin(h, fmax(deep * radius, distance - radius) / speed);
}

/// The same for balls among themselves and against planes: Bullet solves a hit at the start of the
/// part in which it happens, so a short part keeps it where it is.
static double pace_of_balls(const Collide* collide, int s, double h) {
    const Sphere* a = &collide->sphere[s];
    const double radius = (double)a->radius;
    double pace = h;
    for (int k = 0; k < collide->plane_count; k++) {
        const Plane* plane = &collide->plane[k];
        const double gap = ddot(plane->normal, to_double4(a->x) - plane->point) - radius;
        const double speed = fabs(ddot(plane->normal, to_double4(a->v))) + collide->gravity * h;
        if (speed > 0)
            pace = fmin(pace, fmax(deep * radius, gap) / speed);
    }
    for (int k = s + 1; k < collide->sphere_count; k++) {
        const Sphere* b = &collide->sphere[k];
        const double gap = (double)(length(a->x - b->x) - a->radius - b->radius);
        const double speed = (double)length(a->v - b->v);
        if (speed > 0)
            pace = fmin(pace, fmax(deep * fmin(radius, (double)b->radius), gap) / speed);
    }
    return pace;
}

double collide_pace(Collide* collide, double h) {
    if (collide->sphere_count == 0 || collide->law == CONTACT_PAPER)
        return h;
    for (int b = 0; b < collide->skin_count; b++) { // what corrections made of speeds is a way, too
        CollideSkin* skin = &collide->skin[b];
        const double fastest = near_fastest(skin->body);
        skin->grown += collide->drift * fmax(skin->fastest, fastest);
        skin->fastest = fastest;
    }
    collide->contact_count = collide->near_count = 0;
    double pace = h;
    for (int s = 0; s < collide->sphere_count; s++) {
        pace = fmin(pace, pace_of_balls(collide, s, h));
        for (int b = 0; b < collide->skin_count; b++)
            pace = fmin(pace, pace_of(collide, &collide->skin[b], &collide->sphere[s], pace));
    }
    return pace;
}

/// Fastest of a triangle's corners as seen from the ball [m/s].
static double closing(const Contact* c) {
    real fastest = 0;
    for (int k = 0; k < 3; k++) {
        const real4 v = c->sphere->v - c->body->v[c->particle[k]];
        fastest = real_max(fastest, dot(v, v));
    }
    return sqrt((double)fastest);
}

/// What this part's kick alone made of the approach: to it and the ball's weight every contact at
/// rest is exposed.
static real kicked(const Contact* c, const real4* before, real fall) {
    real4 skin = {0, fall, 0, 0};
    for (int k = 0; k < 3; k++)
        skin += c->weight[k] * (c->body->v[c->particle[k]] - before[c->particle[k]]);
    return real_max(0, dot(c->normal, skin));
}

/// A pair's near triangles as contacts: those that may touch in a drift of length h to the front of
/// the list, for the solve; the others stay behind them, for `allowed` and the sweep.
static void gather_pair(Collide* collide, int s, int b, double h) {
    const int number = s * collide->skin_count + b;
    CollidePair* pair = &collide->pair[number];
    CollideSkin* skin = &collide->skin[b];
    Sphere* sphere = &collide->sphere[s];
    const double radius = (double)sphere->radius;
    const double speed = (double)length(sphere->v) + skin->fastest;
    const double reach = (1 + slack) * radius + 2 * speed * h;
    const real fall = (real)(h * collide->gravity);
    bool touching = false;
    pair->seen = fmax(reach, near_box(skin, to_double4(sphere->x)));
    const int count = pair->seen <= reach ? near_triangles(collide, skin, sphere, reach) : 0;
    for (int k = 0; k < count; k++) {
        Contact contact = contact_make(sphere, skin->body, collide->triangle[k], (real)pair->side);
        contact.pair = number;
        contact.first = !pair->touching;
        touching |= contact.gap <= (real)1e-3 * sphere->radius;
        Contact* end = &collide->contact[collide->near_count++];
        *end = contact;
        const double soon = 1.5 * closing(&contact) * h + slack * radius;
        if ((double)contact.gap <= soon && feature_owned(&contact, skin->owners)) {
            *end = collide->contact[collide->contact_count];
            if (contact.first)
                contact.least = bounces * kicked(&contact, skin->before, fall);
            else
                warm_give(&collide->warm, &contact, h);
            collide->contact[collide->contact_count++] = contact;
            body_wake(skin->body);
        }
    }
    pair->touching = touching;
}

static void gather(Collide* collide, double h) {
    collide->contact_count = collide->near_count = collide->warm.next = 0;
    for (int s = 0; s < collide->sphere_count; s++)
        for (int b = 0; b < collide->skin_count; b++)
            gather_pair(collide, s, b, h);
}

/// A hit may have made things faster than they were when the near triangles were looked for: how
/// much of h may be drifted so that none of the others comes into the core of a ball.
static double unseen(Collide* collide, double h) {
    for (int b = 0; b < collide->skin_count; b++)
        collide->skin[b].fastest = near_fastest(collide->skin[b].body);
    for (int s = 0; s < collide->sphere_count; s++)
        for (int b = 0; b < collide->skin_count; b++) {
            Sphere* sphere = &collide->sphere[s];
            const double seen = collide->pair[s * collide->skin_count + b].seen;
            const double speed = (double)length(sphere->v) + collide->skin[b].fastest;
            const double way = speed * h + core * (double)sphere->radius;
            if (way <= seen)
                continue;
            const double distance = near_distance(collide, &collide->skin[b], sphere, way);
            h = fmin(h, (fmax(seen, distance) - core * (double)sphere->radius) / speed);
        }
    return h;
}

/// How much of h may be drifted so that no near triangle comes into the core of a ball.
static double allowed(const Collide* collide, double h) {
    for (int k = 0; k < collide->near_count; k++) {
        const Contact* c = &collide->contact[k];
        const double radius = (double)c->sphere->radius;
        const double room = fmax(least * radius, (double)c->gap + (1 - core) * radius);
        const double speed = closing(c);
        if (speed * h > room)
            h = room / speed;
    }
    return h;
}

/// Whether there was anything to stop.
static bool stop_on_planes(Collide* collide, double h) {
    bool any = false;
    for (int b = 0; collide->plane_count > 0 && b < collide->skin_count; b++) {
        Body* body = collide->skin[b].body;
        if (body->asleep)
            continue;
        const Extent x = extent_of(body->x, body->count), v = extent_of(body->v, body->count);
        for (int k = 0; k < collide->plane_count; k++)
            if (plane_within(&collide->plane[k], &x, &v, h))
                any |= plane_stop(body, &collide->plane[k], h);
    }
    return any;
}

/// Contacts of balls and skins. Skins that are pressed on a plane hand the ball's push on to it,
/// round by round, until there is little left of it.
static void solve(Collide* collide, double h) {
    double first = 0;
    for (int round = 0; round < ROUNDS_WITH_PLANES; round++) {
        const ContactReport report = contact_solve(collide->contact, collide->contact_count, h);
        if (round == 0)
            warm_keep(&collide->warm, collide->contact, collide->contact_count, h);
        first = round == 0 ? report.moved : first;
        if (report.moved <= little * first || !stop_on_planes(collide, h))
            return;
        for (int k = 0; k < collide->contact_count; k++) {
            collide->contact[k].push = 0;
            collide->contact[k].rub = (real4){0, 0, 0, 0};
        }
    }
}

double collide_velocities(Collide* collide, double h) {
    stop_on_planes(collide, h);
    if (collide->sphere_count == 0)
        return h;

    for (int s = 0; s < collide->sphere_count; s++)
        collide->sphere[s].v[1] -= (real)(h * collide->gravity);
    bullet_solve(collide->bullet, collide->sphere, collide->sphere_count, h);
    if (collide->law == CONTACT_PAPER)
        return h;
    gather(collide, h);
    solve(collide, h);
    h = sweep_stop(collide->contact, collide->near_count, allowed(collide, h));
    return unseen(collide, h);
}

void collide_drift(Collide* collide, double h) {
    collide->drift = h;
    for (int k = 0; k < collide->near_count; k++) {
        const Contact* c = &collide->contact[k];
        if (!sweep_passes(c, h))
            continue;
        CollidePair* pair = &collide->pair[c->pair];
        pair->now = -pair->now;
        if (pair->now != pair->side)
            collide->pass_throughs++;
    }
    for (int s = 0; s < collide->sphere_count; s++)
        collide->sphere[s].x += (real)h * collide->sphere[s].v;
}

void collide_penalty(Collide* collide, double h) {
    if (collide->law != CONTACT_PAPER)
        return;
    for (int s = 0; s < collide->sphere_count; s++) {
        Sphere* sphere = &collide->sphere[s];
        for (int b = 0; b < collide->skin_count; b++)
            sphere->v += (real)h / sphere->mass * paper_push(sphere, collide->skin[b].body);
    }
}

void collide_keep(Collide* collide) {
    collide->good_count = collide->sphere_count;
    if (collide->good_count)
        memcpy(collide->good, collide->sphere, (size_t)collide->good_count * sizeof(Sphere));
}

void collide_put_back(Collide* collide) {
    collide->sphere_count = collide->good_count;
    forget(collide);
    if (collide->good_count)
        memcpy(collide->sphere, collide->good, (size_t)collide->good_count * sizeof(Sphere));
}

int collide_bad(const Collide* collide) {
    for (int s = 0; s < collide->sphere_count; s++) {
        const Sphere* sphere = &collide->sphere[s];
        // written so that a NaN fails
        if (!(dot(sphere->x, sphere->x) < (real)INFINITY) ||
            !(dot(sphere->v, sphere->v) < (real)INFINITY))
            return s;
    }
    return NONE;
}

void collide_close(Collide* collide) {
    if (collide->bullet) {
        for (int b = 0; b < collide->skin_count; b++) {
            bullet_skin_close(collide->bullet, collide->skin[b].patches);
            free(collide->skin[b].owners);
        }
        bullet_close(collide->bullet);
    }
    free(collide->plane);
    free(collide->skin);
    free(collide->sphere);
    free(collide->good);
    free(collide->pair);
    free(collide->contact);
    free(collide->triangle);
    free(collide->warm.push);
    *collide = (Collide){0};
}
