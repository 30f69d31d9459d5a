#include "contact/skins/impact_zone.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/inertia.h"
#include "contact/reaction.h"
#include "contact/skins/skin_pairs.h"
#include "mesh/counting_sort.h"

/// Particles of all skins under one numbering.
typedef struct Zones {
    Contacts* contacts;
    int count;   ///< particles
    int* from;   ///< [skins + 1] number of a skin's first particle
    int* parent; ///< [count] a forest; a root is its own parent
    int* zone;   ///< [count] number of a particle's zone, NONE for one alone
    int* start;  ///< [zones + 1] of a zone's particles in member
    int* member; ///< [count]
} Zones;

static void open_zones(Zones* zones, Contacts* contacts) {
    *zones = (Zones){.contacts = contacts, .from = new_array(int, contacts->skin_count + 1)};
    for (int b = 0; b < contacts->skin_count; b++)
        zones->from[b + 1] = zones->from[b] + contacts->skin[b].body->count;
    zones->count = zones->from[contacts->skin_count];
    zones->parent = new_array(int, zones->count);
    zones->zone = new_array(int, zones->count);
    zones->start = new_array(int, zones->count + 1);
    zones->member = new_array(int, zones->count);
    for (int i = 0; i < zones->count; i++)
        zones->parent[i] = i;
}

static void close_zones(Zones* zones) {
    free(zones->from);
    free(zones->parent);
    free(zones->zone);
    free(zones->start);
    free(zones->member);
}

static int number_of(const Zones* zones, const FeaturePair* pair, int k) {
    return zones->from[feature_pair_skin(pair, k)] + pair->node[k];
}

/// A search for pairs that would cross.
typedef struct Joining {
    Zones* zones;
    double h;
    bool any;
} Joining;

/// Join the nodes of a pair that would cross.
static void join(Contacts* contacts, FeaturePair* pair, void* self) {
    Joining* joining = self;
    const Zones* zones = joining->zones;
    const int first = islands_root(zones->parent, number_of(zones, pair, 0));
    bool joined = true;
    for (int k = 1; k < FEATURE_NODES; k++)
        joined &= islands_root(zones->parent, number_of(zones, pair, k)) == first;
    if (joined || skin_pairs_safe_part(contacts, pair, joining->h) >= 1)
        return;
    for (int k = 1; k < FEATURE_NODES; k++)
        zones->parent[islands_root(zones->parent, number_of(zones, pair, k))] =
            islands_root(zones->parent, number_of(zones, pair, 0));
    joining->any = true;
}

/// Number the zones of more than one particle and list their members. Returns how many there are.
static int sort_zones(Zones* zones) {
    int* size = zones->start; // until it is needed
    for (int i = 0; i < zones->count; i++)
        size[i] = 0;
    for (int i = 0; i < zones->count; i++)
        size[islands_root(zones->parent, i)]++;
    int count = 0;
    for (int i = 0; i < zones->count; i++)
        zones->zone[i] = zones->parent[i] == i && size[i] > 1 ? count++ : NONE;
    for (int i = 0; i < zones->count; i++)
        zones->zone[i] = zones->zone[islands_root(zones->parent, i)];
    counting_sort(zones->zone, zones->count, count, zones->start, zones->member);
    return count;
}

typedef struct Particle {
    double4 x;
    real4* v;
    double mass; ///< INFINITY: held
    int skin;
} Particle;

static Particle particle_of(const Zones* zones, int i) {
    int b = 0;
    while (i >= zones->from[b + 1])
        b++;
    const Body* body = zones->contacts->skin[b].body;
    const int k = i - zones->from[b];
    const bool held = body->inverse_mass[k] <= 0 || body->asleep;
    return (Particle){to_double4(body->x[k]), &body->v[k], held ? INFINITY : (double)body->mass[k],
                      b};
}

/// The rigid motion of a zone's momenta.
static void move_rigidly(const Zones* zones, const int* member, int count) {
    double mass = 0;
    double4 center = {0}, momentum = {0}, angular = {0};
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(zones, member[k]);
        mass += p.mass;
        center += p.mass * p.x;
        momentum += p.mass * to_double4(*p.v);
    }
    center /= mass;
    const double4 velocity = momentum / mass;
    Inertia inertia = {{{0}}}, inverse = {{{0}}}; // no spin about an axis without extent
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(zones, member[k]);
        const double4 r = p.x - center;
        angular += p.mass * dcross(r, to_double4(*p.v) - velocity);
        inertia_add(&inertia, p.mass, r);
    }
    inertia_invert(&inertia, &inverse);
    const double4 spin = inertia_times(&inverse, angular);
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(zones, member[k]);
        *p.v = to_real4(velocity + dcross(spin, p.x - center));
    }
}

/// What holds a zone: particles of a skin that do not move, or things.
typedef struct Holder {
    bool held;
    Thing* thing; ///< one that moves; NULL: none
    bool several; ///< they move differently
} Holder;

static Holder holder_of(const Zones* zones, const int* member, int count) {
    Holder holder = {false, NULL, false};
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(zones, member[k]);
        if (p.mass < INFINITY)
            continue;
        Thing* thing = contacts_thing(zones->contacts, p.skin);
        if (thing && thing->body.asleep)
            thing = NULL;
        holder.several |= holder.held && thing != holder.thing;
        holder.held = true;
        holder.thing = holder.thing ? holder.thing : thing;
    }
    return holder;
}

/// Let all things of a zone stand still. They may be in other zones, too.
static void hold_up(const Zones* zones, const int* member, int count) {
    for (int k = 0; k < count; k++) {
        Thing* thing = contacts_thing(zones->contacts, particle_of(zones, member[k]).skin);
        if (thing)
            thing_hold_up(thing);
    }
}

/// The motion of what holds a zone. The impulse of that on the zone's particles is counted for a thing.
static void move_with(const Zones* zones, const Holder* holder, const int* member, int count) {
    Contacts* contacts = zones->contacts;
    const double4 velocity = holder->thing ? holder->thing->velocity : (double4){0};
    int on = NONE; // a thing of the zone
    for (int k = 0; k < count; k++) {
        const int skin = particle_of(zones, member[k]).skin;
        on = contacts_thing(contacts, skin) ? skin - contacts->first_thing : on;
    }
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(zones, member[k]);
        if (!(p.mass < INFINITY))
            continue;
        const double4 change = velocity - to_double4(*p.v);
        *p.v = to_real4(velocity);
        if (on != NONE)
            reaction_add(contacts, p.skin, on, -p.mass * change);
    }
}

/// The rigid motion of a zone's momenta, or that of what holds it. Returns whether that stands still.
static bool move_zone(const Zones* zones, int z) {
    const int* member = zones->member + zones->start[z];
    const int count = zones->start[z + 1] - zones->start[z];
    const Holder holder = holder_of(zones, member, count);
    if (holder.several)
        hold_up(zones, member, count);
    if (holder.held)
        move_with(zones, &(Holder){true, holder.several ? NULL : holder.thing, false}, member,
                  count);
    else
        move_rigidly(zones, member, count);
    return holder.several;
}

/// All zones, and again where one has stopped a thing.
static void move_zones(const Zones* zones, int count) {
    bool again = true;
    while (again) {
        again = false;
        for (int z = 0; z < count; z++)
            again |= move_zone(zones, z);
    }
}

int impact_zones(Contacts* contacts, double h) {
    Zones zones;
    open_zones(&zones, contacts);
    for (;;) {
        Joining joining = {.zones = &zones, .h = h};
        skin_pairs_each_near(contacts, h, 0, join, &joining);
        if (!joining.any)
            break;
        move_zones(&zones, sort_zones(&zones));
    }
    int members = 0;
    for (int i = 0; i < zones.count; i++)
        members += zones.zone[i] != NONE;
    close_zones(&zones);
    return members;
}
