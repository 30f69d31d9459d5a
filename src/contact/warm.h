/// What contacts pushed in the last part, to begin the next solve with.
///
/// A ball that lies on a skin is held by much the same impulses from part to part, in proportion to
/// their lengths. They are a first guess only: applied as impulses, equal and opposite at the new
/// point, so that momenta are kept, and counted and taken back with all others by contact_solve.
/// A first hit is over in its part, and leaves nothing to remember.
/// Source: E. Catto, Iterative dynamics with temporal coherence, Game Developers Conference 2005.
#ifndef BALLOON_CONTACT_WARM_H
#define BALLOON_CONTACT_WARM_H

#include "contact/contact.h"

/// One remembered impulse.
typedef struct Push {
    int pair;     ///< number of ball and skin
    int triangle; ///< of the skin
    real push;    ///< along the normal, in the first solve of the part [N s]
    real4 rub;    ///< across it [N s]
} Push;

typedef struct Warm {
    double h;   ///< length of the part that they are from [s]
    int count;  ///< in rising order of pairs, and of triangles in each
    int next;   ///< first that has not been passed by warm_give
    Push* push; ///< [room for as many as there are contacts]
} Warm;

/// Give a contact the impulse that its pair and triangle had, for a part of length h. The contacts
/// come in the order of the list; `next` is 0 before the first.
void warm_give(Warm* warm, Contact* contact, double h);

/// Remember what these contacts push, after a solve for a part of length h.
void warm_keep(Warm* warm, const Contact* contact, int count, double h);

#endif
