/// How balls and skins meet: what a scene chooses, without the rest of contacts.
#ifndef BALLOON_CONTACT_CONTACT_LAW_H
#define BALLOON_CONTACT_CONTACT_LAW_H

#include <stdbool.h>

typedef enum ContactLaw {
    CONTACT_IMPULSE, ///< momentum kept, nothing passes through
    CONTACT_PAPER,   ///< the mass-spring paper's penalty (contact/paper.h)
    CONTACT_LAWS
} ContactLaw;
extern const char* const contact_law_name[CONTACT_LAWS];

/// Which skins may touch, and how.
typedef struct SkinContacts {
    bool self;       ///< a skin itself
    bool others;     ///< two skins each other
    double friction; ///< Coulomb's coefficient
} SkinContacts;

#endif
