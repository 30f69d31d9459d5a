/// Crossings counted by a program that shares no code with the contacts (lab/bench/exact_crossings.h).
#ifndef BALLOON_TESTS_CROSSINGS_H
#define BALLOON_TESTS_CROSSINGS_H

#include "lab/bench/exact_crossings.h"
#include "worlds.h"

/// Those of all skins, each with itself and the others.
static inline int crossings(const World* world) {
    int count = 0;
    for (int i = 0; i < world->balloon_count; i++)
        for (int j = i; j < world->balloon_count; j++)
            count += exact_crossings(&world->balloon[i].body, &world->balloon[j].body);
    return count;
}

#endif
