/// Where a ball begins: not across a skin.
///
/// The solver keeps a ball and a skin from overlapping by more than half a radius; from a deeper
/// start it has no such bound to keep.
#ifndef BALLOON_CONTACT_BALL_START_H
#define BALLOON_CONTACT_BALL_START_H

#include "contact/contacts.h"

/// Move a ball that overlaps a skin by more than half its radius away from the nearest points until
/// it touches, on the side of the skin where its centre is. Returns the number of the first skin that
/// it overlapped so, or NONE where it was not moved.
int ball_start_clear(Sphere* sphere, const Contacts* contacts);

#endif
