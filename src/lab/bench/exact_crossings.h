/// Crossings of skins counted by a second program, which shares no code with src/contact: the signs of
/// volumes in 113 bits, which are exact for positions in single precision that are less than 2^29
/// times apart in size.
#ifndef BALLOON_LAB_BENCH_EXACT_CROSSINGS_H
#define BALLOON_LAB_BENCH_EXACT_CROSSINGS_H

#include "world/world.h"

/// Pairs of triangles without a common corner of which an edge of one passes through the inside of the
/// other: of two skins, or of one.
int exact_crossings(const Body* a, const Body* b);

/// Those of all balloons with themselves, each other and all things.
int exact_crossings_of_world(const World* world);

#endif
