/// Which triangles of a skin are near a ball. Boxes are refitted only where a ball may reach the
/// skin: between two refits the last box, grown by the way of the skin's fastest particle, says
/// that none does.
#ifndef BALLOON_CONTACT_NEAR_H
#define BALLOON_CONTACT_NEAR_H

#include "contact/contacts.h"

/// Speed of a skin's fastest particle [m/s].
double near_fastest(const Body* body);

/// Boxes of a skin's patches to where it is now.
void near_refit(ContactSkin* skin);

/// No more than the distance of a point from the skin's box; less than 0 where it may be inside.
/// [m]
double near_box(const ContactSkin* skin, double4 point);

/// Triangles of a skin within reach of a ball's centre, into contacts->triangle. Returns the count.
int near_triangles(Contacts* contacts, ContactSkin* skin, const Sphere* sphere, double reach);

/// Distance of a ball's centre to the nearest triangle, or `far` if there is none so near. The
/// reach is doubled until something is in it, so that a far look costs no more than a near one.
double near_distance(Contacts* contacts, ContactSkin* skin, Sphere* sphere, double far);

/// An array of twice the room with the first `count` elements of the old one, which is freed.
void* near_grown(void* old, size_t count, size_t size);

#endif
