#include "contact/contacts.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "contact/triangle_path.h"
#include "contact/shared_feature.h"
#include "contact/broad_phase.h"
#include "contact/pair.h"
#include "contact/paper.h"
#include "contact/ccd.h"

const char* const contact_law_name[CONTACT_LAWS] = {"impulse", "paper"};

enum { CONTACTS_FIRST = 1024, SPHERES_FIRST = 16, MAX_SOLVES = 4 };

static const double min_share = 1e-3; ///< [1] of the energy that the first solve exchanged

const PairRow* const pair_table[PAIR_ROWS] = {
    &pair_ball_plane,
    &pair_ball_ball,
    &pair_ball_skin,
    &pair_skin_plane,
};

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

/// Allocate what only scenes with balls need, at the first ball.
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
        const int full = contacts->sphere_room, pairs = full * contacts->skin_count;
        array_reserve(contacts->sphere, full, (int){full});
        array_reserve(contacts->pair, pairs, (int){pairs});
        array_reserve(contacts->good, full, contacts->sphere_room);
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

/// Invalidate contacts, warm start and boxes.
static void forget(Contacts* contacts) {
    contacts->contact_count = contacts->near_count = contacts->warm.count = 0;
    for (int b = 0; b < contacts->skin_count; b++)
        contacts->skin[b].grown = INFINITY;
}

void contacts_clear(Contacts* contacts) {
    contacts->sphere_count = 0;
    forget(contacts);
}

double contacts_safe_step(Contacts* contacts, double h) {
    if (contacts->sphere_count == 0 || contacts->law == CONTACT_PAPER)
        return h;
    for (int b = 0; b < contacts->skin_count; b++) {
        // corrections after the drift changed speeds: the larger of both bounds the motion
        ContactSkin* skin = &contacts->skin[b];
        const double fastest = broad_phase_max_speed(skin->body);
        skin->grown += contacts->drift * fmax(skin->fastest, fastest);
        skin->fastest = fastest;
    }
    contacts->contact_count = contacts->near_count = 0;
    double safe = h;
    for (int s = 0; s < contacts->sphere_count; s++)
        for (int r = 0; r < PAIR_ROWS; r++)
            if (pair_table[r]->safe_step)
                safe = pair_table[r]->safe_step(contacts, s, h, safe);
    return safe;
}

static void gather(Contacts* contacts, double h) {
    contacts->contact_count = contacts->near_count = contacts->warm.next = 0;
    for (int r = 0; r < PAIR_ROWS; r++)
        if (pair_table[r]->gather)
            pair_table[r]->gather(contacts, h);
}

/// The pairs with a closed form. Returns whether any velocity changed.
static bool stop(Contacts* contacts, double h) {
    bool any = false;
    for (int r = 0; r < PAIR_ROWS; r++)
        if (pair_table[r]->stop)
            any |= pair_table[r]->stop(contacts, h);
    return any;
}

static double limit_drift(Contacts* contacts, double h) {
    for (int r = 0; r < PAIR_ROWS; r++)
        if (pair_table[r]->limit_drift)
            h = pair_table[r]->limit_drift(contacts, h);
    return h;
}

/// The list of contacts. A skin pressed on a plane transmits the ball's impulse to it: solve and
/// closed form alternate until little energy is exchanged.
static void solve(Contacts* contacts, double h) {
    double first = 0;
    for (int n = 0; n < MAX_SOLVES; n++) {
        const ContactReport report = contact_solve(contacts->contact, contacts->contact_count, h);
        if (n == 0)
            warm_start_store(&contacts->warm, contacts->contact, contacts->contact_count, h);
        first = n == 0 ? report.moved : first;
        if (report.moved <= min_share * first || !stop(contacts, h))
            return;
        for (int k = 0; k < contacts->contact_count; k++) {
            contacts->contact[k].normal_impulse = 0;
            contacts->contact[k].tangent_impulse = (real4){0, 0, 0, 0};
        }
    }
}

double contacts_velocities(Contacts* contacts, double h) {
    stop(contacts, h);
    if (contacts->sphere_count == 0)
        return h;

    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].v[1] -= (real)(h * contacts->gravity);
    bullet_solve(contacts->bullet, contacts->sphere, contacts->sphere_count, h);
    if (contacts->law == CONTACT_PAPER)
        return h;
    gather(contacts, h);
    solve(contacts, h);
    return limit_drift(contacts, h);
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
