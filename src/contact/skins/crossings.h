/// Triangles of skins that cross each other.
#ifndef BALLOON_CONTACT_SKINS_CROSSINGS_H
#define BALLOON_CONTACT_SKINS_CROSSINGS_H

#include "body/body.h"

/// Whether a triangle has the point as a corner.
bool crossing_shares(const int triangle[3], int point);

/// Whether triangle t of one skin and u of another, or of the same, cross: an edge of one that has
/// no corner of the other pierces that. Signs of volumes in double; not where one is within rounding
/// of 0.
bool crossing_of(const Body* first, int t, const Body* second, int u);

/// Whether any triangles of two skins cross.
bool crossings_any(const Body* first, const Body* second);

struct Contacts;

/// Pairs of triangles that cross now, of all skins with themselves, each other and things.
int crossings_count(const struct Contacts* contacts);

#endif
