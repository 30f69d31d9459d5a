/// What a scene models and could do without: a table of parts, each with the overrides that take it
/// out of the scene, or put the next simpler thing in its place. A part is of all balloons at once.
#ifndef BALLOON_LAB_ADVICE_NEEDS_PART_H
#define BALLOON_LAB_ADVICE_NEEDS_PART_H

#include "lab/run/overrides.h"
#include "world/world.h"

typedef struct NeedsPart {
    const char* name;
    const char* instead; ///< what is run: "without it", "half as many points each way"

    /// Fill the overrides; none where the scene does not have this part. The world is open and has
    /// made no step.
    void (*simplify)(const World* world, Overrides* sets);
} NeedsPart;

extern const NeedsPart needs_part_table[];
extern const int needs_part_count;

/// Row by name, or NULL.
const NeedsPart* needs_part_find(const char* name);

#endif
