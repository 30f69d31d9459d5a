/// What a scene models and could do without: a table of parts, each with the overrides that take it
/// out of the scene, or put the next simpler thing in its place. A part is of all balloons at once.
#ifndef BALLOON_LAB_ADVICE_NEEDS_PART_H
#define BALLOON_LAB_ADVICE_NEEDS_PART_H

#include "lab/run/overrides.h"
#include "world/world.h"

typedef struct NeedsPart {
    char name[64];
    const char* instead; ///< what is run: "without it", "half as many points each way"

    /// A key whose values are made 0, or are removed where they are no numbers: "balloons.*.helium";
    /// "": what `simplify` does.
    char key[64];

    /// Fill the overrides; none where the scene does not have this part. The world is open and has
    /// made no step.
    void (*simplify)(const World* world, Overrides* sets);

    bool several; ///< only where another number of that key's mapping is not 0 either
} NeedsPart;

/// Part `index` of the table, after which come the forces and the parameters that can be 0; false
/// after the last.
bool needs_part_at(int index, NeedsPart* part);

/// The overrides that take a part out of a scene; none where it does not have it.
void needs_part_simplify(const NeedsPart* part, const World* world, Overrides* sets);

/// Whether there is a part of this name.
bool needs_part_exists(const char* name);

#endif
