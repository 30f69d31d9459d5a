/// The parts of a model: a table, each row with the overrides that remove it from a scene or
/// replace it by a simpler model, in all balloons at once.
#ifndef BALLOON_LAB_ADVICE_NEEDS_PART_H
#define BALLOON_LAB_ADVICE_NEEDS_PART_H

#include "lab/run/overrides.h"
#include "world/world.h"

typedef struct NeedsPart {
    char name[64];
    const char* instead; ///< the replacement, for the table: "without it", "twice as long"

    /// A key, such as "balloons.*.helium", whose numbers are set to 0 and whose other values are
    /// removed; "": use `simplify`.
    char key[64];

    /// Add the overrides; none if the scene lacks this part. The world is open and at its first
    /// state.
    void (*simplify)(const World* world, Overrides* sets);

    bool several; ///< remove a value only if its mapping has another number that is not 0
} NeedsPart;

/// Part `index`: of the table, then of the forces, then of material parameters whose default is 0.
/// False after the last.
bool needs_part_at(int index, NeedsPart* part);

/// Add the overrides that simplify a part; none if the scene lacks it.
void needs_part_simplify(const NeedsPart* part, const World* world, Overrides* sets);

/// Whether a part has this name.
bool needs_part_exists(const char* name);

#endif
