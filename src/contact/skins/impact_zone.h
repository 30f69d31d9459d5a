/// Impact zones: groups of particles that move as rigid bodies for the rest of a drift.
///
/// The last resort where the solver leaves features that would cross: all their nodes get the rigid
/// motion of their momentum and angular momentum, and zones that still meet others grow together. A
/// zone's drift x + h (v + w x (x - c)) is an affine map whose determinant 1 + h^2 |w|^2 is never 0,
/// so nothing within it crosses; both momenta are kept, and the kinetic energy does not rise. A zone
/// with a thing moves as that does; one between two of them that move differently holds both up.
/// Source: X. Provot, Collision and self-collision handling in cloth model, 1997; R. Bridson,
/// R. Fedkiw, J. Anderson, Robust treatment of collisions, contact and friction for cloth animation,
/// ACM Trans. Graph. 21, 2002, section 7.3.
#ifndef BALLOON_CONTACT_SKINS_IMPACT_ZONE_H
#define BALLOON_CONTACT_SKINS_IMPACT_ZONE_H

#include "contact/contacts.h"

/// Change velocities until no pair of the list crosses in a drift of length h. Returns the number of
/// particles in zones.
int impact_zones(Contacts* contacts, double h);

#endif
