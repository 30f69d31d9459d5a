/// Everything that touches: balls and skins, balls and floor, skins and floor.
///
/// A part of a step goes
///
///     pace         how long may everything go before contacts are looked at again
///     kick         velocities under the forces (the caller, solve/)
///     velocities   balls' weight, Bullet's contacts, skins' contacts: velocities for the drift
///     drift        balls move; the caller moves the skins
///
/// so that nothing passes through: in one part a ball and a skin come at most half a radius nearer
/// than touching, and the distance to the nearest triangle gives longer parts where nothing is
/// near. A scene with no ball pays nothing: the pace is what was asked for, and Bullet is not
/// there.
#ifndef BALLOON_CONTACT_CONTACTS_H
#define BALLOON_CONTACT_CONTACTS_H

#include "contact/bullet.h"
#include "contact/contact.h"
#include "contact/contact_law.h"
#include "contact/plane.h"
#include "contact/warm_start.h"

/// A skin that balls can touch.
typedef struct ContactSkin {
    Body* body;             ///< the caller's
    const real4* before;    ///< [count] velocities before the kick, the caller's
    BulletSkin* patches;    ///< NULL until the first ball
    unsigned char* owners;  ///< which triangle a shared corner or edge belongs to (feature.h)
    double low[3], high[3]; ///< box of the skin at its last refit
    double grown;           ///< how far any of it may have gone since then [m]
    double fastest;         ///< speed of its fastest particle in the last drift [m/s]
} ContactSkin;

/// What is remembered of a ball and a skin.
typedef struct ContactPair {
    int side;      ///< 1: the ball began outside the skin, -1 inside
    int now;       ///< on which side it is now: another than `side` has passed through
    bool touching; ///< it touched the skin in the last part: a hit is no longer a first one
    double seen;   ///< every triangle nearer to the ball's centre is in the list of this part [m]
} ContactPair;

typedef struct Contacts {
    ContactLaw law;
    double gravity; ///< [m/s^2] downward, on balls
    int plane_count;
    Plane* plane; ///< [plane_count] floor and walls
    int skin_count;
    ContactSkin* skin; ///< [skin_count]
    int sphere_count;
    int sphere_room;
    Sphere* sphere;    ///< [sphere_room]
    ContactPair* pair; ///< [sphere_room * skin_count], ball after ball
    Bullet* bullet;    ///< NULL until the first ball
    double drift;      ///< length of the last one [s]
    int contact_count; ///< contacts that may touch in this part
    int near_count;    ///< those, and behind them the triangles that are near
    int contact_room;
    Contact* contact; ///< [contact_room]
    int* triangle;    ///< [contact_room]
    WarmStart warm;   ///< what pushed in the last part
    Sphere* good;     ///< [sphere_room] last good state, of the first good_count
    int good_count;
    long pass_throughs;
} Contacts;

/// No balls yet. body: the skins, which must stay where they are; before: the velocities of each
/// before the kick of a part, in which the caller keeps them.
void contacts_open(Contacts* contacts, ContactLaw law, double gravity, const Plane* plane,
                   int plane_count, Body* const* body, const real4* const* before, int body_count);

/// A ball more. It is outside or inside each closed skin, by its winding number, and stays there.
void contacts_add(Contacts* contacts, const Sphere* sphere);

/// No balls any more.
void contacts_clear(Contacts* contacts);

/// How much of h the world may go in its next part [s], greater than 0.
double contacts_safe_step(Contacts* contacts, double h);

/// Velocities that respect all contacts in a drift of length h, wherever a ball may touch a skin
/// that sleeps it is awake; returns how much of h may be drifted, h itself unless the contacts made
/// something much faster.
double contacts_velocities(Contacts* contacts, double h);

/// Count what is about to pass through, and move the balls. Call before the skins drift.
void contacts_drift(Contacts* contacts, double h);

/// The paper's penalty, if that is the law: call after the skins have drifted.
void contacts_penalty(Contacts* contacts, double h);

/// Remember the balls as they are, and put them back; balls added since then go.
void contacts_keep(Contacts* contacts);
void contacts_put_back(Contacts* contacts);

/// The first ball whose place or velocity is not finite, or NONE.
int contacts_bad(const Contacts* contacts);

void contacts_close(Contacts* contacts);

#endif
