/// Which triangles of a skin are near a ball. Boxes are refitted only where a ball may reach the
/// skin: between two refits the last box, grown by the way of the skin's fastest particle, says
/// that none does.
#ifndef BALLOON_CONTACT_BROAD_PHASE_H
#define BALLOON_CONTACT_BROAD_PHASE_H

#include "contact/contacts.h"

/// Speed of a skin's fastest particle [m/s].
double broad_phase_max_speed(const Body* body);

/// Boxes of a skin's patches to where it is now.
void broad_phase_refit(ContactSkin* skin);

/// No more than the distance of a point from the skin's box; less than 0 where it may be inside.
/// [m]
double broad_phase_box_distance(const ContactSkin* skin, double4 point);

/// Triangles of a skin within reach of a ball's centre, into contacts->triangle. Returns the count.
int broad_phase_triangles(Contacts* contacts, ContactSkin* skin, const Sphere* sphere,
                          double reach);

/// Distance of a ball's centre to the nearest triangle, or `far` if there is none so near. The
/// reach is doubled until something is in it, so that a far look costs no more than a near one.
double broad_phase_distance(Contacts* contacts, ContactSkin* skin, Sphere* sphere, double far);

/// An array of twice the room with the first `count` elements of the old one, which is freed.
void* grown_array(void* old, size_t count, size_t size);

#endif
