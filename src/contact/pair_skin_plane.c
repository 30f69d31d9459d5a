#include <stdlib.h>

#include "base/array.h"
#include "contact/pair.h"
#include "contact/reaction.h"

static const real near_share = (real)0.05; ///< [ball radii] from a plane that counts as near
static const double near_size = 0.02;      ///< [body sizes] the same, for an equation

static void stop(Contacts* contacts, double h) {
    for (int b = 0; contacts->plane_count > 0 && b < contacts->first_thing; b++) {
        Body* body = contacts->skin[b].body;
        if (body->asleep)
            continue;
        const Extent x = extent_of(body->x, body->count), v = extent_of(body->v, body->count);
        for (int k = 0; k < contacts->plane_count; k++)
            if (plane_within(&contacts->plane[k], &x, &v, h))
                *reaction_on(contacts, b, k) +=
                    plane_stop(body, &contacts->plane[k], h, &contacts->separation_work);
    }
}

/// The contact of a particle and a plane, in the list because a ball pushes the particle, too.
static void add(Contacts* contacts, int row, int b, int feature, double h) {
    Body* body = contacts->skin[b].body;
    const int i = feature / contacts->plane_count;
    const Plane* plane = &contacts->plane[feature % contacts->plane_count];
    Contact* contact = pair_next(contacts);
    *contact = (Contact){.node_count = 1,
                         .normal = to_real4(plane->normal),
                         .gap = plane_gap(plane, body->x[i]),
                         .size = (real)INFINITY,
                         .friction = plane->friction,
                         .side = {contacts->sphere_count + b, NONE},
                         .row = row,
                         .pair = b,
                         .feature = feature};
    contact->node[0] =
        (ContactNode){&body->v[i], &body->x[i], 1, body->inverse_mass[i], body->mass[i]};
    contact_set_masses(contact);
    pair_keep(contacts, true, h);
}

static int compare(const void* a, const void* b) {
    return *(const int*)a - *(const int*)b;
}

/// Number of a node's particle; NONE where the node is not of this skin.
static int particle_of(const Body* body, const ContactNode* node) {
    const uintptr_t first = (uintptr_t)body->x, at = (uintptr_t)node->position;
    return at >= first && at < (uintptr_t)(body->x + body->count) ? (int)(node->position - body->x)
                                                                  : NONE;
}

/// Features of the particles of skin b that another thing may push onto a plane in a drift of length h, in
/// rising order, each once. Returns the count.
static int pushed_features(Contacts* contacts, int b, int touching, double h) {
    int count = 0;
    for (int j = 0; j < touching; j++) {
        const Contact* c = &contacts->contact[j];
        const int side = contacts->sphere_count + b;
        if (c->side[0] != side && c->side[1] != side)
            continue;
        for (int n = 0; n < c->node_count; n++) {
            const ContactNode* node = &c->node[n];
            const real speed = length(*node->velocity) + length(*c->node[0].velocity);
            const real reach = 2 * (real)h * speed + near_share * c->size;
            const int i = particle_of(contacts->skin[b].body, node);
            if (i == NONE)
                continue;
            for (int k = 0; k < contacts->plane_count; k++)
                if (plane_gap(&contacts->plane[k], *node->position) <= reach) {
                    array_reserve(contacts->candidate, count, contacts->candidate_capacity);
                    contacts->candidate[count++] = i * contacts->plane_count + k;
                }
        }
    }
    if (count == 0) // qsort takes no NULL
        return 0;
    qsort(contacts->candidate, (size_t)count, sizeof(int), compare);
    int kept = 0;
    for (int j = 0; j < count; j++)
        if (j == 0 || contacts->candidate[j] != contacts->candidate[j - 1])
            contacts->candidate[kept++] = contacts->candidate[j];
    return kept;
}

/// A ball or a skin pushes the skin onto a plane: its triangles and their corners on planes are solved as one.
/// All other particles have the closed form.
static void gather(Contacts* contacts, int row, double h) {
    const int touching = contacts->contact_count;
    for (int b = 0; contacts->plane_count > 0 && touching > 0 && b < contacts->first_thing; b++) {
        const int count = pushed_features(contacts, b, touching, h);
        for (int j = 0; j < count; j++)
            add(contacts, row, b, contacts->candidate[j], h);
    }
}

/// Every particle that may come to a plane. Particles beside those that touch are listed, too: the
/// equation finds which of them the step presses on the plane.
static void gather_all(Contacts* contacts, int row, double h) {
    for (int b = 0; contacts->plane_count > 0 && b < contacts->first_thing; b++) {
        const Body* body = contacts->skin[b].body;
        if (body->asleep)
            continue;
        const Extent x = extent_of(body->x, body->count), v = extent_of(body->v, body->count);
        const double reach = 2 * h * extent_length(&v) + near_size * body->size;
        bool near = false;
        for (int k = 0; k < contacts->plane_count; k++)
            near |= plane_box_gap(&contacts->plane[k], &x) <= reach;
        for (int f = 0; near && f < body->count * contacts->plane_count; f++) {
            const int i = f / contacts->plane_count;
            const Plane* plane = &contacts->plane[f % contacts->plane_count];
            if (body->inverse_mass[i] > 0 && (double)plane_gap(plane, body->x[i]) <= reach)
                add(contacts, row, b, f, h);
        }
    }
}

const PairRow pair_skin_plane = {
    .name = "skin-plane",
    .about = "a skin's particles and the floor or a wall; in closed form where no ball pushes them",
    .gather = gather,
    .gather_all = gather_all,
    .stop = stop,
};
