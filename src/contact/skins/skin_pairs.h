/// Pairs of features of skins that are near each other, and the proof that a drift crosses none.
///
/// Each two skins, and each skin with itself, have a list: every vertex and triangle, and every two
/// edges, that were within rest gap + margin of each other when it was made. A bound on the relative
/// motion since then says how long the list holds: all other pairs are farther apart than their rest
/// gap. Features that share a vertex are no pair; two triangles that share one begin to cross where
/// other features of them meet.
///
/// Two skins that cross or meet at the start have no list until they have come apart, nor has a skin
/// that crosses itself: what is inside and what outside is not known of them.
#ifndef BALLOON_CONTACT_SKINS_SKIN_PAIRS_H
#define BALLOON_CONTACT_SKINS_SKIN_PAIRS_H

#include "contact/skins/feature_pair.h"
#include "contact/skins/skin_motion.h"

struct Contacts;

/// The pairs of two skins, or of one.
typedef struct PairList {
    bool crossed; ///< they have crossed since the start: left out
    bool valid;
    double clearance;   ///< relative motion that the list allows [m]
    SkinMotion from[2]; ///< motion of the skins when it was made
    double moved;       ///< bound on the relative motion of any of their points since then [m]
    double holds_until; ///< the list surely holds up to this value of `moved`
    int count, capacity, near_capacity;
    FeaturePair* pair; ///< [capacity] in rising order of kinds and features
    double* near_from; ///< [near_capacity] a pair is not within its rest gap below this `moved`
} PairList;

typedef struct SkinPairs {
    bool begun;         ///< those that began crossed are known
    int updates;        ///< so far
    int64_t drifts;     ///< so far
    TouchingSkin* skin; ///< [skins]; NULL before the first lists
    PairList* list;     ///< [skins][skins] the second number not less than the first
    bool* made;         ///< [skins][skins] lists to make anew
    int count;          ///< pairs in all lists
} SkinPairs;

/// Whether the scene lets skins a and b touch, or a skin itself.
bool skin_pairs_may_touch(const struct Contacts* contacts, int a, int b);

/// Find the skins that cross or meet at the start; skin_pairs_update does, if this was not called.
void skin_pairs_begin(struct Contacts* contacts);

/// Make the lists anew where the motion since they were made, and some drifts of length h at the
/// present velocities, may bring other pairs together.
void skin_pairs_update(struct Contacts* contacts, double h);

/// Make the list of skins a <= b, the boxes of which are of now (contact/skins/skin_pairs_find.c).
void skin_pairs_find(struct Contacts* contacts, int a, int b, double reach);

/// Whether triangles of the two cross now; the boxes must be of now.
bool skin_pairs_cross(struct Contacts* contacts, int a, int b);

/// Call for each pair that may come within (1 + share) rest gaps in a drift of length h at the present
/// velocities, in the order of the lists. The pair's distance, normal and weights are of now. Those
/// whose distance when last measured, less the motion since, rules that out are not looked at.
typedef void PairVisit(struct Contacts* contacts, FeaturePair* pair, void* self);
void skin_pairs_each_near(struct Contacts* contacts, double h, double share, PairVisit* visit,
                          void* self);

/// Part of a drift of length h that is safe for a pair that was measured where it is now, 0 … 1.
/// Displacements are those that the state's precision rounds to.
double skin_pairs_safe_part(const struct Contacts* contacts, const FeaturePair* pair, double h);

/// How much of h may be drifted at the present velocities before a list must be made again [s].
double skin_pairs_limit(struct Contacts* contacts, double h);

/// The skins are about to drift by h, at the velocities of the last limit.
void skin_pairs_moved(struct Contacts* contacts, double h);

/// The rest gap of two skins [m].
double skin_pairs_rest_gap(const struct Contacts* contacts, int a, int b);

void skin_pairs_forget(struct Contacts* contacts);
void skin_pairs_close(struct Contacts* contacts);

#endif
