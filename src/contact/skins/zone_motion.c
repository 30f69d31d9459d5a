#include "contact/skins/zone_motion.h"

#include "base/inertia.h"
#include "base/memory.h"
#include "contact/reaction.h"

static const double kept_share = 0.5; ///< [1] of its clearance that a pair of a zone keeps

/// [1] of coordinates: what double loses of a map's image
static const double map_rounding = 2e-15;

typedef struct Particle {
    double4 x;
    real4* v;
    double mass; ///< INFINITY: held
} Particle;

static Particle particle_of(const Contacts* contacts, const ZoneParticle* p) {
    const Body* body = contacts->skin[p->skin].body;
    const int i = p->particle;
    const bool held = body->inverse_mass[i] <= 0 || body->asleep;
    return (Particle){to_double4(body->x[i]), &body->v[i], held ? INFINITY : (double)body->mass[i]};
}

/// The rigid motion of a zone's momenta.
static void move_rigidly(ZoneMotion* motion, const Contacts* contacts, const ZoneParticle* member,
                         int count, double h) {
    double mass = 0;
    double4 center = {0}, momentum = {0}, angular = {0};
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(contacts, &member[k]);
        mass += p.mass;
        center += p.mass * p.x;
        momentum += p.mass * to_double4(*p.v);
    }
    center /= mass;
    const double4 velocity = momentum / mass;
    Inertia inertia = {{{0}}}, inverse = {{{0}}}; // no spin about an axis without extent
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(contacts, &member[k]);
        const double4 r = p.x - center;
        angular += p.mass * dcross(r, to_double4(*p.v) - velocity);
        inertia_add(&inertia, p.mass, r);
    }
    inertia_invert(&inertia, &inverse);
    const double4 spin = inertia_times(&inverse, angular);
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(contacts, &member[k]);
        *p.v = to_real4(velocity + dcross(spin, p.x - center));
    }
    motion->center = center;
    motion->shift = h * velocity;
    motion->rotation = h * spin;
}

/// The thing that a held particle belongs to, or that holds it; NULL: none.
static Thing* thing_of(const Contacts* contacts, const ZoneParticle* p) {
    Thing* thing = contacts_thing(contacts, p->skin);
    return thing ? thing
                 : pins_thing(&contacts->pins, &contacts->skin[p->skin].body->x[p->particle]);
}

/// How far the map moves a point.
static double4 way_of(const ZoneMotion* motion, double4 x) {
    return motion->thing ? motion->h * thing_velocity(motion->thing, x)
                         : motion->shift + dcross(motion->rotation, x - motion->center);
}

/// What holds a zone: particles of a skin that do not move, or things.
typedef struct Holder {
    bool held;
    Thing* thing; ///< one that moves; NULL: none
    bool several; ///< they move differently
} Holder;

static Holder holder_of(const Contacts* contacts, const ZoneParticle* member, int count) {
    Holder holder = {false, NULL, false};
    for (int k = 0; k < count; k++) {
        if (particle_of(contacts, &member[k]).mass < INFINITY)
            continue;
        Thing* thing = thing_of(contacts, &member[k]);
        if (thing && thing->body.asleep)
            thing = NULL;
        holder.several |= holder.held && thing != holder.thing;
        holder.held = true;
        holder.thing = holder.thing ? holder.thing : thing;
    }
    return holder;
}

/// Let all things of a zone stand still.
static void hold_up(const Contacts* contacts, const ZoneParticle* member, int count) {
    for (int k = 0; k < count; k++) {
        Thing* thing = thing_of(contacts, &member[k]);
        if (thing)
            thing_hold_up(thing);
    }
    pins_follow(&contacts->pins);
}

/// The motion of what holds a zone. The impulse of that on the zone's particles is counted for a thing.
static void move_with(ZoneMotion* motion, const Thing* thing, Contacts* contacts,
                      const ZoneParticle* member, int count, double h) {
    const Thing* on = NULL; // a thing of the zone
    for (int k = 0; k < count; k++) {
        const Thing* one = thing_of(contacts, &member[k]);
        on = one ? one : on;
    }
    for (int k = 0; k < count; k++) {
        const Particle p = particle_of(contacts, &member[k]);
        if (!(p.mass < INFINITY))
            continue;
        const double4 velocity = thing ? thing_velocity(thing, p.x) : (double4){0};
        const double4 change = velocity - to_double4(*p.v);
        *p.v = to_real4(velocity);
        if (on)
            reaction_add(contacts, member[k].skin, (int)(on - contacts->thing), -p.mass * change,
                         p.x);
    }
    motion->shift = thing ? h * thing->velocity.shift : (double4){0};
    motion->thing = thing && thing->spin_max > 0 ? thing : NULL;
    motion->center = motion->rotation = (double4){0};
}

/// Distance of neighboring numbers of the state's precision near a [m].
static double spacing(double a) {
    int exponent;
    frexp(a, &exponent);
    return ldexp((double)REAL_EPSILON, exponent - 1);
}

/// Round the shift to what most of the zone's coordinates can be moved by without rounding.
static void round_shift(ZoneMotion* motion, const Contacts* contacts, const ZoneParticle* member,
                        int count) {
    for (int c = 0; c < 3; c++) {
        double largest = 0;
        for (int k = 0; k < count; k++) {
            const double x = particle_of(contacts, &member[k]).x[c];
            largest = fmax(largest, fmax(fabs(x), fabs(x + motion->shift[c])));
        }
        const double grid = spacing(largest);
        motion->shift[c] = grid > 0 ? grid * nearbyint(motion->shift[c] / grid) : 0;
    }
}

/// Where a skin's particles are after the drift, unless a zone changes it.
static real4* ends_of(Contacts* contacts, int b, double h) {
    TouchingSkin* skin = &contacts->skin_pairs.skin[b];
    const Body* body = contacts->skin[b].body;
    if (!skin->end)
        skin->end = new_array(real4, body->count);
    for (int i = 0; !skin->has_ends && i < body->count; i++)
        skin->end[i] = skin_motion_end(contacts, b, i, h);
    skin->has_ends = true;
    return skin->end;
}

/// Whether x + d has no rounding error. Source: D. Knuth, The Art of Computer Programming, vol. 2,
/// section 4.2.2, theorem B.
static bool adds_exactly(double4 x, double4 d) {
    for (int c = 0; c < 3; c++) {
        const double sum = (double)(real)(x[c] + d[c]), part = sum - x[c];
        if ((x[c] - (sum - part)) + (d[c] - part) != 0)
            return false;
    }
    return true;
}

/// Where the zone's particles are after the drift. Those of what holds it move by themselves.
static void set_ends(ZoneMotion* motion, Contacts* contacts, const ZoneParticle* member, int count,
                     double h) {
    motion->exact = !motion->thing && !(ddot(motion->rotation, motion->rotation) > 0);
    for (int k = 0; k < count; k++) {
        const ZoneParticle* p = &member[k];
        const Particle now = particle_of(contacts, p);
        const double4 way = way_of(motion, now.x);
        const real4 end = to_real4(now.x + way);
        if (now.mass < INFINITY)
            ends_of(contacts, p->skin, h)[p->particle] = end;
        const real4 off = skin_motion_end(contacts, p->skin, p->particle, h) - end;
        motion->exact = motion->exact && adds_exactly(now.x, way) && !(dot(off, off) > 0);
    }
}

bool zone_motion_set(ZoneMotion* motion, Contacts* contacts, const ZoneParticle* member, int count,
                     double h) {
    const Holder holder = holder_of(contacts, member, count);
    motion->thing = NULL;
    motion->h = h;
    const bool stops = holder.several || (holder.thing && motion->path != ZONE_RIGID);
    if (stops)
        hold_up(contacts, member, count);
    if (holder.held)
        move_with(motion, stops ? NULL : holder.thing, contacts, member, count, h);
    else
        move_rigidly(motion, contacts, member, count, h);
    if (motion->path != ZONE_RIGID)
        motion->rotation = (double4){0};
    if (motion->path == ZONE_SHIFTED)
        round_shift(motion, contacts, member, count);
    if (motion->path == ZONE_STILL)
        motion->shift = (double4){0};
    set_ends(motion, contacts, member, count, h);
    return stops;
}

bool zone_motion_keeps(const ZoneMotion* motion, const Contacts* contacts, const FeaturePair* pair,
                       double h) {
    if (motion->exact)
        return true;
    double off[2] = {0, 0}, largest = dlength(motion->shift);
    for (int k = 0; k < FEATURE_NODES; k++) {
        const int b = feature_pair_skin(pair, k), side = k >= (int)pair->kind;
        const double4 x = to_double4(contacts->skin[b].body->x[pair->node[k]]);
        const double4 end = to_double4(skin_motion_end(contacts, b, pair->node[k], h));
        const double4 map = way_of(motion, x);
        off[side] = fmax(off[side], dlength(end - x - map));
        largest = fmax(largest, dlength(x) + dlength(map));
    }
    return off[0] + off[1] + map_rounding * largest <= kept_share * pair->clearance;
}
