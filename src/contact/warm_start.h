/// Contact impulses of the last substep, to start the next solve with.
///
/// A ball at rest on a skin is held by nearly the same impulses in each substep, in proportion to
/// its length. They are only a first guess: contact_solve applies them as impulses, equal and
/// opposite at the new contact point, so momenta are kept, and corrects or undoes them. A first hit
/// ends within its substep and leaves no impulse to store.
/// Source: E. Catto, Iterative dynamics with temporal coherence, Game Developers Conference 2005.
#ifndef BALLOON_CONTACT_WARM_START_H
#define BALLOON_CONTACT_WARM_START_H

#include "contact/contact.h"

typedef struct StoredImpulse {
    int row, pair;         ///< of the contact
    int64_t feature;       ///< of the contact
    real normal_impulse;   ///< of the first solve of the substep [N s]
    real4 tangent_impulse; ///< [N s]
} StoredImpulse;

typedef struct WarmStart {
    double h;  ///< length of the substep that the impulses are from [s]
    int count; ///< in rising order of rows, pairs and features
    int next;  ///< first that warm_start_load has not passed
    int capacity;
    StoredImpulse* impulse; ///< [capacity]
} WarmStart;

/// Load a contact's stored impulse, scaled to a substep of length h. Contacts must come in the order
/// of the list; set `next` to 0 before the first.
void warm_start_load(WarmStart* warm, Contact* contact, double h);

/// Store the impulses after the solve of a substep of length h.
void warm_start_store(WarmStart* warm, const Contact* contact, int count, double h);

#endif
