/// Triangles of skins that cross each other.
#ifndef BALLOON_CONTACT_SKINS_CROSSINGS_H
#define BALLOON_CONTACT_SKINS_CROSSINGS_H

#include <stddef.h>

#include "body/body.h"

/// Whether triangle t of one skin and u of another, or of the same, cross: an edge of one that has
/// no corner of the other pierces that. Signs of volumes in double; not where one is within rounding
/// of 0.
bool crossing_of(const Body* first, int t, const Body* second, int u);

/// Whether any triangles of two skins cross.
bool crossings_any(const Body* first, const Body* second);

/// Pairs of triangles that cross.
typedef struct Crossings {
    int count;
    int skin[2], triangle[2]; ///< of the first pair
} Crossings;

/// Of a skin with itself.
Crossings crossings_of_skin(const Body* body);

struct Contacts;

/// Of all skins with themselves, each other and things as they are now; or only of those that the
/// scene lets touch.
Crossings crossings_find(const struct Contacts* contacts, bool touching);

/// The first two skins, or a skin twice, that do not touch since they crossed or met at the start.
bool crossings_left_out(const struct Contacts* contacts, int skin[2]);

/// A sentence on balloons that cross at the start, or that meet at points where no triangles are
/// known to cross; model: of the first pair's two.
void crossings_say(const Crossings* crossings, const char* model, const char* other_model,
                   char* text, size_t size);

#endif
