#include "contact/contacts.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "contact/triangle_path.h"
#include "contact/shared_feature.h"
#include "contact/broad_phase.h"
#include "contact/paper.h"
#include "contact/ccd.h"

const char* const contact_law_name[CONTACT_LAWS] = {"impulse", "paper"};

enum { CONTACTS_FIRST = 1024, SPHERES_FIRST = 16, ROUNDS_WITH_PLANES = 4 };

static const double deep = 0.5;    ///< [radii] a ball may come nearer than touching in a part
static const double least = 0.05;  ///< [radii] that a part may always go
static const double core = 0.25;   ///< [radii] around the centre that no triangle may come near
static const double slack = 0.05;  ///< [radii] contacts are looked for beyond what speeds say
static const real bounces = 4;     ///< [kicks] of approach; a slower bounce is over in eight parts
static const double little = 1e-3; ///< [1] of the energy that the first round moved

void contacts_open(Contacts* contacts, ContactLaw law, double gravity, const Plane* plane,
                   int plane_count, Body* const* body, const real4* const* before, int body_count) {
    *contacts = (Contacts){
        .law = law,
        .gravity = gravity,
        .plane_count = plane_count,
        .plane = new_array(Plane, plane_count),
        .skin_count = body_count,
        .skin = new_array(ContactSkin, body_count),
    };
    for (int k = 0; k < plane_count; k++)
        contacts->plane[k] = plane[k];
    for (int b = 0; b < body_count; b++)
        contacts->skin[b] = (ContactSkin){.body = body[b], .before = before[b]};
}

/// What only a scene with balls needs, made at the first of them.
static void begin(Contacts* contacts) {
    contacts->bullet = bullet_open();
    for (int k = 0; k < contacts->plane_count; k++) {
        const double4 p = contacts->plane[k].point, n = contacts->plane[k].normal;
        bullet_add_plane(contacts->bullet, (double[]){p[0], p[1], p[2]},
                         (double[]){n[0], n[1], n[2]});
    }
    for (int b = 0; b < contacts->skin_count; b++) {
        ContactSkin* skin = &contacts->skin[b];
        const Mesh* mesh = skin->body->mesh;
        skin->owners = shared_feature_owners(mesh);
        skin->patches = bullet_skin_open((const int(*)[3])mesh->triangle, mesh->triangle_count,
                                         skin->body->x, mesh->point_count);
        skin->fastest = broad_phase_max_speed(skin->body);
        skin->grown = INFINITY;
    }
    contacts->contact_room = CONTACTS_FIRST;
    contacts->contact = new_array(Contact, CONTACTS_FIRST);
    contacts->triangle = new_array(int, CONTACTS_FIRST);
    contacts->warm.impulse = new_array(StoredImpulse, CONTACTS_FIRST);
    contacts->sphere_room = SPHERES_FIRST;
    contacts->sphere = new_array(Sphere, SPHERES_FIRST);
    contacts->good = new_array(Sphere, SPHERES_FIRST);
    contacts->pair = new_array(ContactPair, SPHERES_FIRST * contacts->skin_count);
}

void contacts_add(Contacts* contacts, const Sphere* sphere) {
    if (!contacts->bullet)
        begin(contacts);
    if (contacts->sphere_count == contacts->sphere_room) {
        const size_t room = (size_t)contacts->sphere_room;
        contacts->sphere = grown_array(contacts->sphere, room, sizeof(Sphere));
        contacts->good = grown_array(contacts->good, room, sizeof(Sphere));
        contacts->pair =
            grown_array(contacts->pair, room * (size_t)contacts->skin_count, sizeof(ContactPair));
        contacts->sphere_room *= 2;
    }
    const int s = contacts->sphere_count++;
    contacts->sphere[s] = *sphere;
    for (int b = 0; b < contacts->skin_count; b++) {
        const Body* body = contacts->skin[b].body;
        const bool inside =
            body->mesh->closed && winding_number(body->mesh, body->x, to_double4(sphere->x)) > 0.5;
        const int side = inside ? -1 : 1;
        contacts->pair[s * contacts->skin_count + b] = (ContactPair){.side = side, .now = side};
    }
}

/// What is known of contacts and boxes is no longer so.
static void forget(Contacts* contacts) {
    contacts->contact_count = contacts->near_count = contacts->warm.count = 0;
    for (int b = 0; b < contacts->skin_count; b++)
        contacts->skin[b].grown = INFINITY;
}

void contacts_clear(Contacts* contacts) {
    contacts->sphere_count = 0;
    forget(contacts);
}

/// How long a ball may go before it has to look at a skin again.
static double pace_of(Contacts* contacts, ContactSkin* skin, Sphere* sphere, double h) {
    const double radius = (double)sphere->radius;
    const double speed = (double)length(sphere->v) + contacts->gravity * h + skin->fastest;
    const double reach = radius + speed * h;
    if (speed * h <= deep * radius ||
        broad_phase_box_distance(skin, to_double4(sphere->x)) >= reach)
        return h;
    broad_phase_refit(skin);
    if (broad_phase_box_distance(skin, to_double4(sphere->x)) >= reach)
        return h;
    const double distance = broad_phase_distance(contacts, skin, sphere, reach);
    return fmin(h, fmax(deep * radius, distance - radius) / speed);
}

/// The same for balls among themselves and against planes: Bullet solves a hit at the start of the
/// part in which it happens, so a short part keeps it where it is.
static double pace_of_balls(const Contacts* contacts, int s, double h) {
    const Sphere* a = &contacts->sphere[s];
    const double radius = (double)a->radius;
    double pace = h;
    for (int k = 0; k < contacts->plane_count; k++) {
        const Plane* plane = &contacts->plane[k];
        const double gap = ddot(plane->normal, to_double4(a->x) - plane->point) - radius;
        const double speed = fabs(ddot(plane->normal, to_double4(a->v))) + contacts->gravity * h;
        if (speed > 0)
            pace = fmin(pace, fmax(deep * radius, gap) / speed);
    }
    for (int k = s + 1; k < contacts->sphere_count; k++) {
        const Sphere* b = &contacts->sphere[k];
        const double gap = (double)(length(a->x - b->x) - a->radius - b->radius);
        const double speed = (double)length(a->v - b->v);
        if (speed > 0)
            pace = fmin(pace, fmax(deep * fmin(radius, (double)b->radius), gap) / speed);
    }
    return pace;
}

double contacts_safe_step(Contacts* contacts, double h) {
    if (contacts->sphere_count == 0 || contacts->law == CONTACT_PAPER)
        return h;
    for (int b = 0; b < contacts->skin_count;
         b++) { // what corrections made of speeds is a way, too
        ContactSkin* skin = &contacts->skin[b];
        const double fastest = broad_phase_max_speed(skin->body);
        skin->grown += contacts->drift * fmax(skin->fastest, fastest);
        skin->fastest = fastest;
    }
    contacts->contact_count = contacts->near_count = 0;
    double pace = h;
    for (int s = 0; s < contacts->sphere_count; s++) {
        pace = fmin(pace, pace_of_balls(contacts, s, h));
        for (int b = 0; b < contacts->skin_count; b++)
            pace = fmin(pace, pace_of(contacts, &contacts->skin[b], &contacts->sphere[s], pace));
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
        skin -= c->weight[k + 1] * (c->body->v[c->particle[k]] - before[c->particle[k]]);
    return real_max(0, dot(c->normal, skin));
}

/// A pair's near triangles as contacts: those that may touch in a drift of length h to the front of
/// the list, for the solve; the others stay behind them, for `allowed` and the sweep.
static void gather_pair(Contacts* contacts, int s, int b, double h) {
    const int number = s * contacts->skin_count + b;
    ContactPair* pair = &contacts->pair[number];
    ContactSkin* skin = &contacts->skin[b];
    Sphere* sphere = &contacts->sphere[s];
    const double radius = (double)sphere->radius;
    const double speed = (double)length(sphere->v) + skin->fastest;
    const double reach = (1 + slack) * radius + 2 * speed * h;
    const real fall = (real)(h * contacts->gravity);
    bool touching = false;
    pair->seen = fmax(reach, broad_phase_box_distance(skin, to_double4(sphere->x)));
    const int count =
        pair->seen <= reach ? broad_phase_triangles(contacts, skin, sphere, reach) : 0;
    for (int k = 0; k < count; k++) {
        Contact contact = contact_make(sphere, skin->body, contacts->triangle[k], (real)pair->side);
        contact.pair = number;
        contact.first = !pair->touching;
        touching |= contact.gap <= (real)1e-3 * sphere->radius;
        Contact* end = &contacts->contact[contacts->near_count++];
        *end = contact;
        const double soon = 1.5 * closing(&contact) * h + slack * radius;
        if ((double)contact.gap <= soon && shared_feature_owned(&contact, skin->owners)) {
            *end = contacts->contact[contacts->contact_count];
            if (contact.first)
                contact.min_bounce_speed = bounces * kicked(&contact, skin->before, fall);
            else
                warm_start_load(&contacts->warm, &contact, h);
            contacts->contact[contacts->contact_count++] = contact;
            body_wake(skin->body);
        }
    }
    pair->touching = touching;
}

static void gather(Contacts* contacts, double h) {
    contacts->contact_count = contacts->near_count = contacts->warm.next = 0;
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int b = 0; b < contacts->skin_count; b++)
            gather_pair(contacts, s, b, h);
}

/// A hit may have made things faster than they were when the near triangles were looked for: how
/// much of h may be drifted so that none of the others comes into the core of a ball.
static double unseen(Contacts* contacts, double h) {
    for (int b = 0; b < contacts->skin_count; b++)
        contacts->skin[b].fastest = broad_phase_max_speed(contacts->skin[b].body);
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int b = 0; b < contacts->skin_count; b++) {
            Sphere* sphere = &contacts->sphere[s];
            const double seen = contacts->pair[s * contacts->skin_count + b].seen;
            const double speed = (double)length(sphere->v) + contacts->skin[b].fastest;
            const double way = speed * h + core * (double)sphere->radius;
            if (way <= seen)
                continue;
            const double distance = broad_phase_distance(contacts, &contacts->skin[b], sphere, way);
            h = fmin(h, (fmax(seen, distance) - core * (double)sphere->radius) / speed);
        }
    return h;
}

/// How much of h may be drifted so that no near triangle comes into the core of a ball.
static double allowed(const Contacts* contacts, double h) {
    for (int k = 0; k < contacts->near_count; k++) {
        const Contact* c = &contacts->contact[k];
        const double radius = (double)c->sphere->radius;
        const double room = fmax(least * radius, (double)c->gap + (1 - core) * radius);
        const double speed = closing(c);
        if (speed * h > room)
            h = room / speed;
    }
    return h;
}

/// Whether there was anything to stop.
static bool stop_on_planes(Contacts* contacts, double h) {
    bool any = false;
    for (int b = 0; contacts->plane_count > 0 && b < contacts->skin_count; b++) {
        Body* body = contacts->skin[b].body;
        if (body->asleep)
            continue;
        const Extent x = extent_of(body->x, body->count), v = extent_of(body->v, body->count);
        for (int k = 0; k < contacts->plane_count; k++)
            if (plane_within(&contacts->plane[k], &x, &v, h))
                any |= plane_stop(body, &contacts->plane[k], h);
    }
    return any;
}

/// Contacts of balls and skins. Skins that are pressed on a plane hand the ball's push on to it,
/// round by round, until there is little left of it.
static void solve(Contacts* contacts, double h) {
    double first = 0;
    for (int round = 0; round < ROUNDS_WITH_PLANES; round++) {
        const ContactReport report = contact_solve(contacts->contact, contacts->contact_count, h);
        if (round == 0)
            warm_start_store(&contacts->warm, contacts->contact, contacts->contact_count, h);
        first = round == 0 ? report.moved : first;
        if (report.moved <= little * first || !stop_on_planes(contacts, h))
            return;
        for (int k = 0; k < contacts->contact_count; k++) {
            contacts->contact[k].normal_impulse = 0;
            contacts->contact[k].tangent_impulse = (real4){0, 0, 0, 0};
        }
    }
}

double contacts_velocities(Contacts* contacts, double h) {
    stop_on_planes(contacts, h);
    if (contacts->sphere_count == 0)
        return h;

    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].v[1] -= (real)(h * contacts->gravity);
    bullet_solve(contacts->bullet, contacts->sphere, contacts->sphere_count, h);
    if (contacts->law == CONTACT_PAPER)
        return h;
    gather(contacts, h);
    solve(contacts, h);
    h = ccd_stop(contacts->contact, contacts->near_count, allowed(contacts, h));
    return unseen(contacts, h);
}

void contacts_drift(Contacts* contacts, double h) {
    contacts->drift = h;
    for (int k = 0; k < contacts->near_count; k++) {
        const Contact* c = &contacts->contact[k];
        if (!ccd_passes_through(c, h))
            continue;
        ContactPair* pair = &contacts->pair[c->pair];
        pair->now = -pair->now;
        if (pair->now != pair->side)
            contacts->pass_throughs++;
    }
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].x += (real)h * contacts->sphere[s].v;
}

void contacts_penalty(Contacts* contacts, double h) {
    if (contacts->law != CONTACT_PAPER)
        return;
    for (int s = 0; s < contacts->sphere_count; s++) {
        Sphere* sphere = &contacts->sphere[s];
        for (int b = 0; b < contacts->skin_count; b++)
            sphere->v += (real)h / sphere->mass * paper_push(sphere, contacts->skin[b].body);
    }
}

void contacts_keep(Contacts* contacts) {
    contacts->good_count = contacts->sphere_count;
    if (contacts->good_count)
        memcpy(contacts->good, contacts->sphere, (size_t)contacts->good_count * sizeof(Sphere));
}

void contacts_put_back(Contacts* contacts) {
    contacts->sphere_count = contacts->good_count;
    forget(contacts);
    if (contacts->good_count)
        memcpy(contacts->sphere, contacts->good, (size_t)contacts->good_count * sizeof(Sphere));
}

int contacts_bad(const Contacts* contacts) {
    for (int s = 0; s < contacts->sphere_count; s++) {
        const Sphere* sphere = &contacts->sphere[s];
        // written so that a NaN fails
        if (!(dot(sphere->x, sphere->x) < (real)INFINITY) ||
            !(dot(sphere->v, sphere->v) < (real)INFINITY))
            return s;
    }
    return NONE;
}

void contacts_close(Contacts* contacts) {
    if (contacts->bullet) {
        for (int b = 0; b < contacts->skin_count; b++) {
            bullet_skin_close(contacts->skin[b].patches);
            free(contacts->skin[b].owners);
        }
        bullet_close(contacts->bullet);
    }
    free(contacts->plane);
    free(contacts->skin);
    free(contacts->sphere);
    free(contacts->good);
    free(contacts->pair);
    free(contacts->contact);
    free(contacts->triangle);
    free(contacts->warm.impulse);
    *contacts = (Contacts){0};
}
