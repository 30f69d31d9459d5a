#include <math.h>

#include "contact/skins/impact_zone.h"
#include "contact/pair.h"
#include "contact/skins/skin_pairs.h"

// a drift is made in parts, each with a solve of its own; where they become too short or too many,
// the rest of it is made by impact zones
static const double part_min = 0.05; ///< [1] of a kick's drift
enum { PARTS_MAX = 16 };

static const double slack = 0.1;  ///< [rest gaps] more than the speeds close
static const double margin = 1.5; ///< [1] of what they close, for the speeds that the solve changes

/// [rest gaps] The solver keeps skins farther apart, unless they have no place left.
static const double squeezed_gap = 0.05;

static double safe_step(Contacts* contacts, double h) {
    skin_pairs_update(contacts, h);
    return h;
}

/// Whether no neighbor of the pair's triangle, of a thing, is nearer to the vertex.
static bool is_nearest(const Contacts* contacts, const FeaturePair* pair) {
    const Thing* thing = contacts_thing(contacts, pair->skin[1]);
    const double weight[3] = {-pair->weight[1], -pair->weight[2], -pair->weight[3]};
    return !thing ||
           thing_is_nearest(thing, (int)(pair->feature & 0x7fffffff), weight,
                            to_double4(contacts->skin[pair->skin[0]].body->x[pair->node[0]]));
}

/// Whether the nearest points are within both features; or on an edge or a corner, where a vertex and
/// the first triangle of the list that has it stand for all pairs with the same nearest points.
static bool stands_for_itself(const Contacts* contacts, const FeaturePair* pair) {
    int on = 0; // bit k: node k has a weight
    for (int k = 0; k < FEATURE_NODES; k++)
        on |= (pair->weight[k] != 0) << k;
    if (pair->kind == EDGE_EDGE)
        return on == 0xf;
    if (on == 0xf)
        return true;
    const int owners = contacts->skin[pair->skin[1]].owners[(int)(pair->feature & 0x7fffffff)];
    for (int k = 0; k < 3; k++) {
        const int corner = 2 << k, next = 2 << (k + 1) % 3;
        if (on == (1 | corner))
            return (owners >> k & 1) && is_nearest(contacts, pair);
        if (on == (1 | corner | next))
            return (owners >> (3 + k) & 1) && is_nearest(contacts, pair);
    }
    return true;
}

/// Fastest approach of any two corners of the two along the normal [m/s].
static double closing_speed(const Contacts* contacts, const FeaturePair* pair) {
    double first = INFINITY, second = -INFINITY;
    for (int k = 0; k < FEATURE_NODES; k++) {
        const Body* body = contacts->skin[feature_pair_skin(pair, k)].body;
        const double along = ddot(pair->normal, to_double4(body->v[pair->node[k]]));
        if (k < (int)pair->kind)
            first = fmin(first, along);
        else
            second = fmax(second, along);
    }
    return fmax(second - first, 0);
}

static void set_node(Contacts* contacts, Contact* contact, const FeaturePair* pair, int k) {
    Body* body = contacts->skin[feature_pair_skin(pair, k)].body;
    const int i = pair->node[k];
    const real weight = (real)pair->weight[k];
    const bool held = body->inverse_mass[i] <= 0;
    contact->node[k] =
        (ContactNode){&body->v[i], &body->x[i], weight, held ? 0 : weight * body->inverse_mass[i],
                      held ? (real)INFINITY : body->mass[i]};
}

/// Rises from list to list, and within a list with its order.
static int number_of(const Contacts* contacts, const FeaturePair* pair) {
    const int a = pair->skin[0], b = pair->skin[1];
    const int list = a < b ? a * contacts->skin_count + b : b * contacts->skin_count + a;
    return 4 * list + 2 * (a > b) + (int)pair->kind - 1;
}

static void add(Contacts* contacts, int row, const FeaturePair* pair, double h) {
    // the number of a thing's skin is the greater one
    const int first = pair->skin[0], second = pair->skin[1];
    const bool swapped = contacts_thing(contacts, first);
    const Thing* thing = contacts_thing(contacts, swapped ? first : second);
    Contact* contact = pair_next(contacts);
    *contact = (Contact){.node_count = FEATURE_NODES,
                         .normal = to_real4(pair->normal),
                         .gap = (real)(pair->distance - pair->rest_gap),
                         .size = (real)contacts->skin_pairs.skin[first].scale,
                         .friction = thing ? thing->friction : (real)contacts->skins.friction,
                         .side = {contacts->sphere_count + (swapped ? second : first),
                                  contacts->sphere_count + (swapped ? first : second)},
                         .row = row,
                         .pair = number_of(contacts, pair),
                         .feature = pair->feature};
    real response = 0;
    for (int k = 0; k < FEATURE_NODES; k++) {
        set_node(contacts, contact, pair, k);
        response += contact->node[k].weight * contact->node[k].response;
    }
    if (response <= 0) // all are held
        return;
    contact_set_masses(contact);
    if (contact->friction > 0)
        contact_set_couple(contact, pair->distance * pair->normal);
    contacts_wake(contacts, first, second);
    contacts_wake(contacts, second, first);
    pair_keep(contacts, true, h);
}

typedef struct Gathering {
    int row;
    double h;
} Gathering;

static void gather_pair(Contacts* contacts, FeaturePair* pair, void* self) {
    const Gathering* gathering = self;
    const double closed = margin * gathering->h * closing_speed(contacts, pair);
    for (int side = 0; side < 2 && pair->distance < squeezed_gap * pair->rest_gap; side++)
        contacts->skin_pairs.skin[pair->skin[side]].squeezed = true;
    if (pair->distance <= (1 + slack) * pair->rest_gap + closed &&
        stands_for_itself(contacts, pair))
        add(contacts, gathering->row, pair, gathering->h);
}

/// Hold up the things that touch a skin which has no place left.
static void hold_things(Contacts* contacts) {
    const int spheres = contacts->sphere_count, first_thing = spheres + contacts->first_thing;
    for (int k = 0; k < contacts->contact_count; k++) {
        const Contact* c = &contacts->contact[k];
        if (c->side[1] >= first_thing && c->side[0] >= spheres &&
            contacts->skin_pairs.skin[c->side[0] - spheres].squeezed)
            thing_hold_up(&contacts->thing[c->side[1] - first_thing]);
    }
    pins_follow(&contacts->pins);
}

static void gather(Contacts* contacts, int row, double h) {
    for (int b = 0; contacts->skin_pairs.skin && b < contacts->first_thing; b++)
        contacts->skin_pairs.skin[b].squeezed = false;
    skin_pairs_each_near(contacts, margin * h, slack, gather_pair, &(Gathering){row, h});
    hold_things(contacts);
}

/// The safe part of a drift so far.
typedef struct SafePart {
    double h;
    double part;
} SafePart;

static void shorten(Contacts* contacts, FeaturePair* pair, void* self) {
    SafePart* safe = self;
    safe->part *= skin_pairs_safe_part(contacts, pair, safe->part * safe->h);
}

static double safe_part(Contacts* contacts, double h) {
    SafePart safe = {h, 1};
    skin_pairs_each_near(contacts, h, 0, shorten, &safe);
    return safe.part;
}

/// A shorter drift rounds other displacements than a share of the longer one has: again until none
/// of them crosses.
static double safe_drift(Contacts* contacts, double h) {
    for (double part = 0; part < 1; h *= part)
        part = safe_part(contacts, h);
    return h;
}

static double limit_drift(Contacts* contacts, double h) {
    h = skin_pairs_limit(contacts, h);
    if (contacts->skin_pairs.count == 0)
        return h;
    const double safe = safe_drift(contacts, h);
    if (safe == h || (contacts->part < PARTS_MAX && safe > part_min * contacts->kicked))
        return safe;
    contacts->zone_particles += impact_zones(contacts, &h);
    return h;
}

const PairRow pair_skin_skin = {
    .name = "skin-skin",
    .about = "vertices and triangles, edges and edges of two skins or of one",
    .safe_step = safe_step,
    .gather = gather,
    .limit_drift = limit_drift,
};
