/// Broad phase: which triangles of a skin are near a ball. The boxes are refitted only where a ball
/// may reach the skin; until then the last box, grown by the path of the skin's fastest particle,
/// rules contact out.
#ifndef BALLOON_CONTACT_BROAD_PHASE_H
#define BALLOON_CONTACT_BROAD_PHASE_H

#include "contact/contacts.h"

/// The patches and the owners of shared features, once something may touch the skin.
void broad_phase_open(ContactSkin* skin);

/// Speed of a skin's fastest particle [m/s].
double broad_phase_max_speed(const Body* body);

/// Refit the boxes of a skin's patches to the present positions.
void broad_phase_refit(ContactSkin* skin);

/// Lower bound of a point's distance from the skin's box; below 0 where it may be inside [m].
double broad_phase_box_distance(const ContactSkin* skin, double4 point);

/// Triangles of a skin within reach of a ball's centre, into contacts->candidate. Returns the count.
int broad_phase_triangles(Contacts* contacts, ContactSkin* skin, const Sphere* sphere,
                          double reach);

/// Distance of a ball's centre to the nearest triangle, at most `far`. The reach is doubled until a
/// triangle is within it, so that a search costs in proportion to the distance.
double broad_phase_distance(Contacts* contacts, ContactSkin* skin, Sphere* sphere, double far);

#endif
