/// The kinds of pairs that can touch: one file and one row each.
///
/// A row states the time until the pair must be tested again (conservative advancement), adds its
/// contacts to the list that contact_solve solves, shortens the drift if the solve raised speeds,
/// and counts what the drift passes through. A function that a pair does not need is NULL. Without
/// anything that may touch, each returns at once.
#ifndef BALLOON_CONTACT_PAIR_H
#define BALLOON_CONTACT_PAIR_H

#include "contact/contacts.h"

typedef struct PairRow {
    const char* name;
    const char* about;

    /// How long everything may move until the pair must be looked at again [s]: greater than 0 and at
    /// most h.
    double (*safe_step)(Contacts* contacts, double h);

    /// Add the contacts that may touch in a drift of length h, by pair_keep; they bear the number of
    /// the row.
    void (*gather)(Contacts* contacts, int row, double h);

    /// The same for a method whose equation contains the contacts, from the velocities before the
    /// step; NULL: gather.
    void (*gather_all)(Contacts* contacts, int row, double h);

    /// Closed form, before the list: change velocities for a drift of length h.
    void (*stop)(Contacts* contacts, double h);

    /// How much of h may be drifted after the solve [s].
    double (*limit_drift)(Contacts* contacts, double h);

    /// Count what passes through in a drift of length h, before it.
    void (*count_passes)(Contacts* contacts, double h);
} PairRow;

extern const PairRow pair_ball_plane, pair_ball_ball, pair_ball_skin, pair_skin_plane,
    pair_skin_skin;

enum { PAIR_ROWS = 5 };
extern const PairRow* const pair_table[PAIR_ROWS];

/// The next contact of the list, for a row to fill in; pair_keep adds it. Contacts of a row come in
/// rising order of their pairs and features.
Contact* pair_next(Contacts* contacts);

/// Add the contact that pair_next gave. If it may touch in a drift of length h, it stays in the list
/// for the solver, with the impulse that its pair had in the last part; else it goes to the list of
/// near triangles, for the limits of the drift.
void pair_keep(Contacts* contacts, bool may_touch, double h);

/// [radii] by which the two may come nearer than touching in a substep.
static const double pair_max_overlap = 0.5;

/// [1/s] times h: a rigid pair that closes more slowly does not bounce. A ball at rest falls g h in a
/// part; this is twice the Earth's g [m/s^2].
static const double pair_min_bounce = 20;

/// [radii] A rigid pair this near counts as touching.
static const double pair_touching = 0.01;

/// At most `safe`, and so long that two, `gap` apart, come no nearer than touching by more than that
/// share of `radius` [s].
static inline double pair_safe_time(double safe, double gap, double radius, double speed) {
    return speed > 0 ? fmin(safe, fmax(pair_max_overlap * radius, gap) / speed) : safe;
}

/// Whether a rigid pair bounces: it closes its gap in a drift of length h, and faster than a pair at
/// rest. longest: the longer of this drift and the last, of which both have kicked it.
static inline bool pair_bounces(double gap, double closing, double h, double longest) {
    return closing * h >= gap && closing > pair_min_bounce * longest;
}

/// [1] of the height of a bounce that may be lost because it begins before the ball has come down.
static const double pair_early_share = 2e-4;
static const double pair_min_drift = 0.01; ///< [1] of a drift that a hit may shorten it to

/// [1] of the time to a hit: a drift that ends at it would have the bounce in it, or not, by rounding
static const double pair_before_hit = 1 - 1e-4;

/// A ball bounces at the start of the drift in which it hits, `gap` above the surface: there is less
/// energy to lose than at the surface, so it rises by (1 - e^2) gap too high. Whether that counts, for
/// a hit of this squared speed.
static inline bool pair_bounces_early(double gravity, double e, double gap, double impact2) {
    return 2 * gravity * (1 - e * e) * gap > pair_early_share * e * e * impact2;
}

/// Whether the contact is of a ball and a triangle, the corners of which are nodes 1 to 3.
static inline bool pair_has_triangle(const Contact* contact) {
    return contact->lever_count == 1 && contact->node_count == CONTACT_NODES;
}

/// Node and lever of a ball on one side of a contact, `along` from its centre to the contact point
/// against the normal if sign is 1, along it if -1 [m].
static inline void pair_set_ball(Contact* contact, int k, Sphere* sphere, real sign, real along) {
    contact->node[k] =
        (ContactNode){&sphere->v, &sphere->x, sign, sign / sphere->mass, sphere->mass};
    contact->lever[k] =
        (ContactLever){-along * contact->normal, &sphere->spin, 1 / sphere_inertia(sphere)};
}

#endif
