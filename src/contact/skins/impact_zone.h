/// Impact zones: groups of particles that move as rigid bodies for the rest of a drift.
///
/// The last resort where the solver leaves features that would cross: all their nodes get the rigid
/// motion of their momentum and angular momentum, and zones that still meet others grow together. A
/// zone's drift x + h (v + w x (x - c)) is an affine map whose determinant 1 + h^2 |w|^2 is never 0,
/// so nothing within it crosses; both momenta are kept, and the kinetic energy does not rise. A zone
/// with a thing moves as that does; one between two of them that move differently holds both up.
///
/// **No state crosses after one that does not**, in any precision:
/// * Every statement is about the stored positions x and the stored ends x' of the drift, on straight
///   paths between them, and is a proof by a plane or by a bound on motion in double. Its own rounding
///   is subtracted (feature_clearance), so nearest points that are inexact only make it more careful.
/// * Pairs not in a list, or not within their rest gaps, cannot meet (skin_pairs.h).
/// * A pair of which not all nodes are in one zone is safe by skin_pairs_safe_part, or joins one.
/// * A pair within a zone is apart by more than what rounding moved its nodes from the zone's map, or
///   all nodes of the zone have moved by one vector exactly: then nothing within it has changed. Where
///   that does not hold, the zone goes less far, in the end not at all (zone_motion.h).
/// * Each round without an end joins particles or lets a zone go less far: rounds are finite. It ends
///   with all particles at rest at the latest, which crosses nothing.
/// * Positions that the drift stores are those ends (contacts_place).
/// Source: X. Provot, Collision and self-collision handling in cloth model, 1997; R. Bridson,
/// R. Fedkiw, J. Anderson, Robust treatment of collisions, contact and friction for cloth animation,
/// ACM Trans. Graph. 21, 2002, section 7.3.
#ifndef BALLOON_CONTACT_SKINS_IMPACT_ZONE_H
#define BALLOON_CONTACT_SKINS_IMPACT_ZONE_H

#include "contact/contacts.h"

/// Change velocities, and where particles of zones are after the drift, until no pair of the list crosses
/// in a drift of length *h; that becomes shorter where the lists of pairs do not hold as long at these
/// velocities. Returns the number of particles in zones.
int impact_zones(Contacts* contacts, double* h);

#endif
