#include "contact/contacts.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "contact/triangle_path.h"
#include "contact/broad_phase.h"
#include "contact/pair.h"
#include "contact/paper.h"
#include "contact/reaction.h"

const char* const contact_law_name[CONTACT_LAWS] = {"impulse", "paper"};

void contacts_open(Contacts* contacts, ContactLaw law, double gravity, const Plane* plane,
                   int plane_count, SkinContacts skins, Body* const* body,
                   const real4* const* before, int body_count) {
    *contacts = (Contacts){
        .law = law,
        .gravity = gravity,
        .plane_count = plane_count,
        .plane = new_array(Plane, plane_count),
        .plane_impulse = new_array(double, (body_count + 1) * plane_count),
        .skins = skins,
        .skin_count = body_count,
        .first_thing = body_count,
        .skin = new_array(ContactSkin, body_count),
    };
    for (int k = 0; k < plane_count; k++)
        contacts->plane[k] = plane[k];
    for (int b = 0; b < body_count; b++)
        contacts->skin[b] = (ContactSkin){.body = body[b], .before = before[b]};
}

void contacts_add_things(Contacts* contacts, Thing* thing, int count) {
    ASSERT(contacts->sphere_count == 0, "pairs of balls and skins are numbered by the skins");
    const int skins = contacts->first_thing;
    ContactSkin* skin = new_array(ContactSkin, skins + count);
    if (skins > 0)
        memcpy(skin, contacts->skin, (size_t)skins * sizeof *skin);
    free(contacts->skin);
    for (int k = 0; k < count; k++)
        skin[skins + k] = (ContactSkin){.body = &thing[k].body};
    contacts->skin = skin;
    contacts->skin_count = skins + count;
    contacts->thing = thing;
    contacts->thing_count = count;
    contacts->thing_impulse = new_array(ThingImpulse, (skins + 1) * count);
}

void contacts_wake(Contacts* contacts, int skin, int other) {
    if (contacts_thing(contacts, skin))
        return;
    Body* body = contacts->skin[skin].body;
    const bool is_ball = other == NONE, is_thing = !is_ball && contacts_thing(contacts, other);
    if (!is_ball && !(is_thing ? !contacts->skin[other].body->asleep : body->asleep))
        return;
    contacts->woke |= body->asleep;
    body_wake(body);
}

/// Allocate what only scenes with balls need, at the first ball.
static void begin(Contacts* contacts) {
    contacts->balls = bullet_balls_open();
    for (int b = 0; b < contacts->skin_count; b++) {
        ContactSkin* skin = &contacts->skin[b];
        broad_phase_open(skin);
        skin->fastest = broad_phase_max_speed(skin->body);
        skin->path_max = INFINITY;
    }
}

void contacts_add(Contacts* contacts, const Sphere* sphere) {
    if (!contacts->balls)
        begin(contacts);
    const int s = contacts->sphere_count++;
    array_reserve(contacts->sphere, s, contacts->sphere_capacity);
    array_reserve(contacts->good, s, contacts->good_capacity);
    array_reserve(contacts->start, s, contacts->start_capacity);
    contacts->sphere[s] = *sphere;
    for (int b = 0; b < contacts->skin_count; b++) {
        const Body* body = contacts->skin[b].body;
        const bool inside =
            body->mesh->closed && winding_number(body->mesh, body->x, to_double4(sphere->x)) > 0.5;
        const int side = inside ? -1 : 1, number = s * contacts->skin_count + b;
        array_reserve(contacts->pair, number, contacts->pair_capacity);
        contacts->pair[number] = (ContactPair){.side = side, .present_side = side};
    }
}

/// Invalidate contacts, warm start and boxes.
static void forget(Contacts* contacts) {
    contacts->contact_count = contacts->near_count = contacts->warm.count = 0;
    for (int b = 0; b < contacts->skin_count; b++)
        contacts->skin[b].path_max = INFINITY;
    skin_pairs_forget(contacts);
}

void contacts_clear(Contacts* contacts) {
    contacts->sphere_count = 0;
    contacts->drift = contacts->kicked = 0;
    forget(contacts);
}

double contacts_safe_step(Contacts* contacts, double h) {
    contacts->contact_count = contacts->near_count = 0;
    if (contacts->law == CONTACT_PAPER) // its figures are of whole steps
        return h;
    for (int k = 0; k < contacts->thing_count; k++)
        h = thing_safe_step(&contacts->thing[k], h);
    for (int k = 0; k < contacts->thing_count; k++) {
        thing_begin_drift(&contacts->thing[k], h);
        if (contacts->thing[k].still >
            0) // impulses against each other would grow from part to part
            contacts->warm.count = 0;
    }
    contacts->woke |= pins_follow(&contacts->pins);
    for (int r = 0; r < PAIR_ROWS; r++)
        if (pair_table[r]->safe_step)
            h = pair_table[r]->safe_step(contacts, h);
    return h;
}

/// The rows' contacts: for an equation, those with a closed form too.
static void gather(Contacts* contacts, double h, bool for_equation) {
    contacts->contact_count = contacts->near_count = contacts->warm.next = 0;
    for (int r = 0; r < PAIR_ROWS; r++)
        if (for_equation && pair_table[r]->gather_all)
            pair_table[r]->gather_all(contacts, r, h);
        else if (pair_table[r]->gather)
            pair_table[r]->gather(contacts, r, h);
}

/// The pairs with a closed form.
static void stop(Contacts* contacts, double h) {
    for (int r = 0; r < PAIR_ROWS; r++)
        if (pair_table[r]->stop)
            pair_table[r]->stop(contacts, h);
}

static double limit_drift(Contacts* contacts, double h) {
    for (int r = 0; r < PAIR_ROWS; r++)
        if (pair_table[r]->limit_drift)
            h = pair_table[r]->limit_drift(contacts, h);
    return h;
}

static void solve(Contacts* contacts, double h) {
    if (contacts->contact_count == 0)
        return;
    Islands* islands = &contacts->islands;
    islands_find(islands, contacts->contact, contacts->contact_count,
                 contacts->sphere_count + contacts->first_thing);
    for (int i = 0; i < islands->count; i++)
        contacts->separation_work +=
            fmax(0, contact_solve(islands->contact + islands->start[i],
                                  islands->start[i + 1] - islands->start[i], h)
                        .kinetic);
}

static void add_weight(Contacts* contacts, double h) {
    const real fall = (real)(contacts_fall_time(contacts, h) * contacts->gravity);
    contacts->kicked = h;
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].v[1] -= fall;
}

static double velocities(Contacts* contacts, double h) {
    gather(contacts, h, false);
    reaction_begin(contacts);
    solve(contacts, h);
    warm_start_store(&contacts->warm, contacts->contact, contacts->contact_count, h);
    h = limit_drift(contacts, h);
    reaction_end(contacts);
    return h;
}

static void copy_balls(Sphere* to, const Sphere* from, int count) {
    if (count > 0)
        memcpy(to, from, (size_t)count * sizeof *to);
}

void contacts_begin(Contacts* contacts, double h) {
    copy_balls(contacts->start, contacts->sphere, contacts->sphere_count);
    contacts->start_kicked = contacts->kicked;
    add_weight(contacts, h);
    gather(contacts, h, true);
    reaction_begin(contacts);
    for (int k = 0; k < contacts->contact_count; k++)
        contact_set_bounds(&contacts->contact[k], h);
}

void contacts_undo(Contacts* contacts) {
    copy_balls(contacts->sphere, contacts->start, contacts->sphere_count);
    contacts->kicked = contacts->start_kicked;
}

double contacts_finish(Contacts* contacts, double h) {
    contacts->part = 0;
    reaction_add_contacts(contacts);
    warm_start_store(&contacts->warm, contacts->contact, contacts->contact_count, h);
    stop(contacts, h);
    gather(contacts, h, false);
    for (int k = 0; k < contacts->contact_count; k++) { // the equation has applied them
        contacts->contact[k].normal_impulse = 0;
        contacts->contact[k].tangent_impulse = (real4){0, 0, 0, 0};
    }
    solve(contacts, h);
    h = limit_drift(contacts, h);
    reaction_end(contacts);
    return h;
}

double contacts_velocities(Contacts* contacts, double h) {
    contacts->part = 0;
    stop(contacts, h);
    add_weight(contacts, h);
    return velocities(contacts, h);
}

bool contacts_in_parts(const Contacts* contacts) {
    return contacts->skin_pairs.skin != NULL;
}

double contacts_velocities_again(Contacts* contacts, double h) {
    contacts->part++;
    h = contacts_safe_step(contacts, h);
    stop(contacts, h);
    return velocities(contacts, h);
}

void contacts_drift(Contacts* contacts, double h) {
    contacts->drift = contacts->part > 0 ? contacts->drift + h : h;
    contacts->skins_kicked = false;
    skin_pairs_moved(contacts, h);
    for (int r = 0; r < PAIR_ROWS; r++)
        if (pair_table[r]->count_passes)
            pair_table[r]->count_passes(contacts, h);
    for (int s = 0; s < contacts->sphere_count; s++)
        contacts->sphere[s].x += (real)h * contacts->sphere[s].v;
    for (int k = 0; k < contacts->thing_count; k++)
        thing_drift(&contacts->thing[k], h);
}

void contacts_place(Contacts* contacts, int skin) {
    if (!contacts->skin_pairs.skin || !contacts->skin_pairs.skin[skin].has_ends)
        return;
    TouchingSkin* touching = &contacts->skin_pairs.skin[skin];
    const Body* body = contacts->skin[skin].body;
    memcpy(body->x, touching->end, (size_t)body->count * sizeof *body->x);
    touching->has_ends = false;
}

void contacts_penalty(Contacts* contacts, double h) {
    if (contacts->law != CONTACT_PAPER)
        return;
    for (int s = 0; s < contacts->sphere_count; s++) {
        Sphere* sphere = &contacts->sphere[s];
        const real4 before = sphere->v;
        for (int b = 0; b < contacts->first_thing; b++)
            sphere->v += (real)h / sphere->mass * paper_push(sphere, contacts->skin[b].body);
        sphere->impulse += sphere->mass * (sphere->v - before);
    }
}

void contacts_keep(Contacts* contacts) {
    contacts->good_drift = contacts->drift;
    contacts->good_kicked = contacts->kicked;
    contacts->good_count = contacts->sphere_count;
    copy_balls(contacts->good, contacts->sphere, contacts->good_count);
    for (int k = 0; k < contacts->thing_count; k++)
        thing_keep(&contacts->thing[k]);
}

void contacts_put_back(Contacts* contacts) {
    contacts->drift = contacts->good_drift;
    contacts->kicked = contacts->good_kicked;
    contacts->sphere_count = contacts->good_count;
    forget(contacts);
    copy_balls(contacts->sphere, contacts->good, contacts->good_count);
    for (int k = 0; k < contacts->thing_count; k++)
        thing_put_back(&contacts->thing[k]);
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
    for (int b = 0; b < contacts->skin_count; b++) {
        if (contacts->skin[b].patches)
            bullet_skin_close(contacts->skin[b].patches);
        free(contacts->skin[b].owners);
    }
    if (contacts->balls)
        bullet_balls_close(contacts->balls);
    skin_pairs_close(contacts);
    free(contacts->plane);
    free(contacts->plane_impulse);
    free(contacts->thing_impulse);
    pins_close(&contacts->pins);
    free(contacts->skin);
    free(contacts->sphere);
    free(contacts->good);
    free(contacts->start);
    free(contacts->pair);
    free(contacts->contact);
    free(contacts->near);
    free(contacts->candidate);
    free(contacts->warm.impulse);
    islands_close(&contacts->islands);
    *contacts = (Contacts){0};
}
