/// How the particles of an impact zone move: velocities, and positions after the coming drift.
///
/// A zone's velocities are those of its momentum and angular momentum, or of what holds it. Its
/// positions follow one affine map x + d + r x (x - c), d = h v, r = h w, of double precision, and are
/// rounded once. Two of its points that were a distance D apart are afterward, and on straight paths
/// between, at least D - e apart, e the sum of what rounding moved each: the map's least singular value
/// is 1. A zone with a thing that rotates follows that thing's own map, which is one of a quarter radian
/// at most: on straight paths it is never less than 0.99 D - e. Where D - e may not be positive, the positions do less than the velocities say:
///
///     ZONE_RIGID     x + d + r x (x - c), rounded
///     ZONE_SHIFTED   x + d', d' rounded to a multiple of the coarsest spacing of the zone's
///                    coordinates: most additions are exact
///     ZONE_STILL     x
///
/// Momenta are kept in each: positions do not enter the momentum, and the angular momentum changes
/// by d' x (sum of m v), which is 0 but for rounding.
#ifndef BALLOON_CONTACT_SKINS_ZONE_MOTION_H
#define BALLOON_CONTACT_SKINS_ZONE_MOTION_H

#include "contact/contacts.h"

typedef enum ZonePath { ZONE_RIGID, ZONE_SHIFTED, ZONE_STILL } ZonePath;

/// A particle of a zone.
typedef struct ZoneParticle {
    int skin, particle;
} ZoneParticle;

typedef struct ZoneMotion {
    ZonePath path;
    double4 center, shift, rotation; ///< c, d, r of the map that positions follow
    const Thing* thing;              ///< whose rotation they follow instead, NULL: none
    double h;                        ///< length of the drift [s]
    bool exact; ///< all particles have moved by the same vector, and nothing was rounded
} ZoneMotion;

/// Set the velocities of a zone's particles and where they are after a drift of length h. Returns
/// whether a thing was held up: other zones may have it, too.
bool zone_motion_set(ZoneMotion* motion, Contacts* contacts, const ZoneParticle* member, int count,
                     double h);

/// Whether a pair of which all nodes are in the zone stays apart in the drift.
bool zone_motion_keeps(const ZoneMotion* motion, const Contacts* contacts, const FeaturePair* pair,
                       double h);

#endif
