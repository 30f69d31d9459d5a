/// Forces of contacts: impulses of a step over its length.
///
/// A plane has the sum of the normal impulses of what it stops, and a thing that of all impulses on
/// it, skin by skin and of all balls together; a ball has the change of its momentum by contacts, of
/// its weight not. A skin that sleeps presses on as in its last step.
#ifndef BALLOON_CONTACT_REACTION_H
#define BALLOON_CONTACT_REACTION_H

#include "contact/contacts.h"

/// Normal impulse that a skin has given to a plane in this step; skin == first_thing: all balls [N s].
static inline double* reaction_on(Contacts* contacts, int skin, int plane) {
    return &contacts->plane_impulse[skin * contacts->plane_count + plane];
}

/// Add an impulse that a skin or, where skin == first_thing, a ball gives to a thing at x [N s], and
/// the work that the thing does on its path.
void reaction_add(Contacts* contacts, int skin, int thing, double4 impulse, double4 x);

/// Forget the impulses of the last step, but not those of sleeping skins.
void reaction_clear(Contacts* contacts);

/// Before and after the solve of the contacts: count what it changes.
void reaction_begin(Contacts* contacts);
void reaction_end(Contacts* contacts);

/// Count what the contacts of the list give to planes and things.
void reaction_add_contacts(Contacts* contacts);

/// Normal impulse on a plane in this step [N s].
double reaction_of_plane(const Contacts* contacts, int plane);

/// Impulse on a thing in this step; its moment about the thing's present origin.
ThingImpulse reaction_of_thing(const Contacts* contacts, int thing);

#endif
