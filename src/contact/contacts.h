/// All contacts of a world, between balls, skins, things and planes.
///
/// A substep is
///
///     safe step    how long until contacts must be found again (conservative advancement)
///     kick         velocities under the forces (the caller, solve/)
///     velocities   balls' weight, then one solve of all contacts: velocities for the drift
///     drift        balls move; the caller moves the skins
///
/// so that nothing passes through: in one substep a ball and a skin overlap by at most half a radius,
/// and where no triangle is near, the distance to the nearest one allows longer substeps. A scene
/// without balls pays nothing: the safe step is the step, and Bullet is not started. The kinds of
/// pairs are a table (contact/pair.h).
#ifndef BALLOON_CONTACT_CONTACTS_H
#define BALLOON_CONTACT_CONTACTS_H

#include "body/body.h"
#include "contact/bullet/trees.h"
#include "contact/contact.h"
#include "contact/contact_law.h"
#include "contact/islands.h"
#include "contact/plane.h"
#include "contact/skins/skin_pairs.h"
#include "contact/things/pins.h"
#include "contact/things/thing.h"
#include "contact/warm_start.h"

/// Of contacts on a thing.
typedef struct ThingImpulse {
    double4 linear;  ///< [N s]
    double4 angular; ///< about the origin of the world [N m s]
} ThingImpulse;

/// A skin that balls and skins can touch.
typedef struct ContactSkin {
    Body* body;            ///< the caller's
    const real4* before;   ///< [count] velocities before the kick, the caller's
    BulletSkin* patches;   ///< NULL until something may touch the skin
    unsigned char* owners; ///< which triangle a shared corner or edge belongs to (shared_feature.h)
    double low[3], high[3]; ///< box of the skin at its last refit
    double path_max;        ///< bound on the path of any of its particles since then [m]
    double fastest;         ///< speed of its fastest particle in the last drift [m/s]
} ContactSkin;

/// State of a ball and a skin from substep to substep.
typedef struct ContactPair {
    int side;         ///< 1: the ball began outside the skin, -1 inside
    int present_side; ///< another than `side`: it has passed through
    bool touching;    ///< it touched the skin in the last part: a hit is no longer a first one
    double searched;  ///< every triangle nearer to the ball's centre is in this part's list [m]
} ContactPair;

typedef struct Contacts {
    ContactLaw law;
    double gravity; ///< [m/s^2] downward, on balls
    int plane_count;
    Plane* plane; ///< [plane_count] floor and walls
    double*
        plane_impulse; ///< [(first_thing + 1) * plane_count] of this step (contact/reaction.h) [N s]
    int thing_count;
    Thing* thing;                ///< [thing_count] the caller's
    ThingImpulse* thing_impulse; ///< [(first_thing + 1) * thing_count] the same
    Pins pins;                   ///< particles that things hold
    int skin_count;
    int first_thing;   ///< skins from this number on are those of things
    ContactSkin* skin; ///< [skin_count]
    int sphere_count;
    int sphere_capacity;
    Sphere* sphere; ///< [sphere_capacity]
    int pair_capacity;
    ContactPair* pair;  ///< [sphere_count * skin_count], ball after ball
    BulletBalls* balls; ///< broad phase of the balls; NULL until the first one
    SkinContacts skins; ///< which skins may touch
    SkinPairs skin_pairs;
    double drift;      ///< length of the last one, of all its parts so far [s]
    double kicked;     ///< length of the substep that the last kick was for [s]
    bool skins_kicked; ///< since the last drift
    int part;          ///< of that drift, which contacts of skins divide
    int contact_count, contact_capacity;
    Contact* contact; ///< [contact_capacity] that may touch in this part
    int near_count, near_capacity;
    Contact* near; ///< [near_capacity] of balls and triangles that are near and cannot touch in it
    int candidate_capacity;
    int* candidate;  ///< [candidate_capacity] features that a search found
    Islands islands; ///< of the contacts that may touch
    WarmStart warm;  ///< what pushed in the last part
    int good_count, good_capacity;
    Sphere* good; ///< [good_capacity] last good state of the balls
    double good_drift, good_kicked;
    int start_capacity;
    Sphere* start;       ///< [start_capacity] the balls before contacts_begin
    double start_kicked; ///< `kicked` then [s]
    long pass_throughs;
    bool woke; ///< a sleeping skin was touched: its bound on the step is not in the guard's
    long zone_particles; ///< particles that were in impact zones, summed over drifts
    double
        separation_work; ///< kinetic energy given to undo overlaps with planes and of balls, and by
                         ///< things on their paths, so far [J]
} Contacts;

/// No balls yet. body: the skins, which must stay where they are; before: the velocities of each
/// before the kick of a part, in which the caller keeps them.
void contacts_open(Contacts* contacts, ContactLaw law, double gravity, const Plane* plane,
                   int plane_count, SkinContacts skins, Body* const* body,
                   const real4* const* before, int body_count);

/// Add things, the caller's, before the first ball.
void contacts_add_things(Contacts* contacts, Thing* thing, int count);

/// The thing of a skin, or NULL.
static inline Thing* contacts_thing(const Contacts* contacts, int skin) {
    return skin < contacts->first_thing ? NULL : &contacts->thing[skin - contacts->first_thing];
}

/// Wake a skin that another one touches, or a ball (NONE). A thing has no sleep to wake from, and
/// one at rest wakes nothing. What is awake may yet fall asleep by another balloon, with it.
void contacts_wake(Contacts* contacts, int skin, int other);

/// Add a ball. It is outside or inside each closed skin, by its winding number, and stays there.
void contacts_add(Contacts* contacts, const Sphere* sphere);

/// No balls any more.
void contacts_clear(Contacts* contacts);

/// Length of the next substep [s], greater than 0 and at most h.
double contacts_safe_step(Contacts* contacts, double h);

/// Velocities that respect all contacts in a drift of length h. A sleeping skin wakes where a ball
/// may touch it. Returns how much of h may be drifted: h, unless contacts made something much
/// faster.
double contacts_velocities(Contacts* contacts, double h);

/// The same for a method whose equation contains the contacts, in two parts around its solve. Before:
/// balls' weight, and the list of the contacts that may touch, among them all particles near planes,
/// with the warm start's impulses and the lower bounds of n.u'.
void contacts_begin(Contacts* contacts, double h);

/// Where the equation was not solved: the balls' velocities as they were before contacts_begin.
void contacts_undo(Contacts* contacts);

/// After: keep the list's impulses for the next warm start; then solve what the equation left or did
/// not contain. Returns how much of h may be drifted.
double contacts_finish(Contacts* contacts, double h);

/// Whether a drift that contacts shorten is made in parts after one kick, with contacts solved anew
/// for each: with skins that touch, which may need many. Else the rest of it has a kick of its own.
bool contacts_in_parts(const Contacts* contacts);

/// Velocities for the rest of a drift that was shortened: no weight acts again.
double contacts_velocities_again(Contacts* contacts, double h);

/// Count the pass-throughs of this drift, and move the balls. Call before the skins drift.
void contacts_drift(Contacts* contacts, double h);

/// Time for which gravity acts on the balls' velocities before a drift of length h [s]. As in
/// leapfrog these are the velocities in the middle of a drift, so that a ball flies on one parabola
/// through drifts of any lengths: half of the last drift's time, as it was kicked for, is in them.
static inline double contacts_fall_time(const Contacts* contacts, double h) {
    return contacts->drift > 0 ? contacts->drift - contacts->kicked / 2 + h / 2 : h;
}

/// Put a skin, which has drifted, where impact zones have decided, if they have.
void contacts_place(Contacts* contacts, int skin);

/// The paper's penalty, if that is the law: call after the skins have drifted.
void contacts_penalty(Contacts* contacts, double h);

/// Island of a ball or a skin among the contacts of the last part; NONE: it may touch nothing.
static inline int contacts_island(const Contacts* contacts, int side) {
    return contacts->contact_count > 0 ? islands_of_side(&contacts->islands, side) : NONE;
}

/// Whether two skins are one or of one island.
static inline bool contacts_join(const Contacts* contacts, int a, int b) {
    const int island = contacts_island(contacts, contacts->sphere_count + a);
    return a == b ||
           (island != NONE && contacts_island(contacts, contacts->sphere_count + b) == island);
}

/// Remember the balls as they are, and put them back; balls added since then go.
void contacts_keep(Contacts* contacts);
void contacts_put_back(Contacts* contacts);

/// The first ball whose position or velocity is not finite, or NONE.
int contacts_bad(const Contacts* contacts);

void contacts_close(Contacts* contacts);

#endif
