#include "contact/skins/impact_zone.h"

#include <stdlib.h>

#include "base/memory.h"
#include "contact/skins/skin_pairs.h"
#include "contact/skins/zone_motion.h"
#include "mesh/counting_sort.h"

/// Particles of all skins under one numbering.
typedef struct Zones {
    Contacts* contacts;
    int count;      ///< particles
    int* from;      ///< [skins + 1] number of a skin's first particle
    int* parent;    ///< [count] a forest; a root is its own parent
    ZonePath* path; ///< [count] of a root's zone
    int* zone; ///< [count] number of a root's zone, NONE for one alone or a zone to be moved anew
    int zone_count;
    ZoneMotion* motion;   ///< [zone_count]
    int* start;           ///< [zone_count + 1] of a zone's particles in member
    int* order;           ///< [count] numbers of particles, zone after zone
    ZoneParticle* member; ///< [count] the same
} Zones;

static void open_zones(Zones* zones, Contacts* contacts) {
    *zones = (Zones){.contacts = contacts, .from = new_array(int, contacts->skin_count + 1)};
    for (int b = 0; b < contacts->skin_count; b++)
        zones->from[b + 1] = zones->from[b] + contacts->skin[b].body->count;
    zones->count = zones->from[contacts->skin_count];
    zones->parent = new_array(int, zones->count);
    zones->zone = new_array(int, zones->count);
    zones->start = new_array(int, zones->count + 1);
    zones->order = new_array(int, zones->count);
    zones->member = new_array(ZoneParticle, zones->count);
    zones->path = new_array(ZonePath, zones->count);
    zones->motion = new_array(ZoneMotion, zones->count);
    for (int i = 0; i < zones->count; i++) {
        zones->parent[i] = i;
        zones->zone[i] = NONE;
    }
}

static void close_zones(Zones* zones) {
    free(zones->from);
    free(zones->parent);
    free(zones->zone);
    free(zones->start);
    free(zones->order);
    free(zones->member);
    free(zones->path);
    free(zones->motion);
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

/// Join the nodes of a pair that would cross. Where they are of one zone, that goes less far.
static void join(Contacts* contacts, FeaturePair* pair, void* self) {
    Joining* joining = self;
    const Zones* zones = joining->zones;
    int root[FEATURE_NODES];
    bool joined = true;
    ZonePath path = ZONE_RIGID;
    for (int k = 0; k < FEATURE_NODES; k++) {
        root[k] = islands_root(zones->parent, number_of(zones, pair, k));
        joined &= root[k] == root[0];
        path = zones->path[root[k]] > path ? zones->path[root[k]] : path;
    }
    const int zone = zones->zone[root[0]];
    if (joined &&
        (zone == NONE || zone_motion_keeps(&zones->motion[zone], contacts, pair, joining->h)))
        return;
    if (joined)
        path++;
    else if (skin_pairs_safe_part(contacts, pair, joining->h) >= 1)
        return;
    for (int k = 1; k < FEATURE_NODES; k++)
        zones->parent[islands_root(zones->parent, root[k])] = islands_root(zones->parent, root[0]);
    const int all = islands_root(zones->parent, root[0]);
    zones->path[all] = path;
    zones->zone[all] = NONE;
    joining->any = true;
}

/// Number the zones of more than one particle and list their members.
static void sort_zones(Zones* zones) {
    int* size = zones->start; // until it is needed
    for (int i = 0; i < zones->count; i++)
        size[i] = 0;
    for (int i = 0; i < zones->count; i++)
        size[islands_root(zones->parent, i)]++;
    zones->zone_count = 0;
    for (int i = 0; i < zones->count; i++) {
        zones->zone[i] = NONE;
        if (zones->parent[i] != i || size[i] < 2)
            continue;
        ASSERT(zones->path[i] <= ZONE_STILL, "nothing within a zone at rest crosses");
        zones->motion[zones->zone_count] = (ZoneMotion){.path = zones->path[i]};
        zones->zone[i] = zones->zone_count++;
    }
    for (int i = 0; i < zones->count; i++)
        zones->zone[i] = zones->zone[islands_root(zones->parent, i)];
    counting_sort(zones->zone, zones->count, zones->zone_count, zones->start, zones->order);
    for (int k = 0; k < zones->start[zones->zone_count]; k++) {
        int b = 0;
        while (zones->order[k] >= zones->from[b + 1])
            b++;
        zones->member[k] = (ZoneParticle){b, zones->order[k] - zones->from[b]};
    }
}

/// The motions of all zones, and again where one has stopped a thing.
static void move_zones(const Zones* zones, double h) {
    bool again = true;
    while (again) {
        again = false;
        for (int z = 0; z < zones->zone_count; z++)
            again |=
                zone_motion_set(&zones->motion[z], zones->contacts, zones->member + zones->start[z],
                                zones->start[z + 1] - zones->start[z], h);
    }
}

/// Change velocities and ends until no pair crosses in a drift of length h. Returns the number of
/// particles in zones.
static int make_zones(Contacts* contacts, double h) {
    Zones zones;
    open_zones(&zones, contacts);
    for (;;) {
        Joining joining = {.zones = &zones, .h = h};
        skin_pairs_each_near(contacts, h, 0, join, &joining);
        if (!joining.any)
            break;
        sort_zones(&zones);
        move_zones(&zones, h);
    }
    int members = 0;
    for (int i = 0; i < zones.count; i++)
        members += zones.zone[i] != NONE;
    close_zones(&zones);
    return members;
}

int impact_zones(Contacts* contacts, double* h) {
    for (;;) {
        for (int b = 0; b < contacts->skin_count; b++)
            contacts->skin_pairs.skin[b].has_ends = false;
        const int members = make_zones(contacts, *h);
        const double limit = skin_pairs_limit(contacts, *h);
        if (limit == *h)
            return members;
        *h = limit; // velocities have changed; a shorter drift rounds otherwise
    }
}
