/// Catches a state that goes bad, restores the last good one and halts the world.
///
/// A state is bad when a particle's position is not finite, or when a particle moves in one drift by
/// more than ten times the balloon's first size relative to the balloon's mean. It is also bad when
/// a ball is not finite, a gas has lost its volume, or an element of rubber its thickness. It is
/// found at the step where it happens, in every mode of the guard, and the sentence names the cause
/// that was measured. The last good state is at most GUARD_INTERVAL steps old.
#ifndef BALLOON_WORLD_GUARD_BLOWUP_H
#define BALLOON_WORLD_GUARD_BLOWUP_H

#include "world/guard/guard.h"

/// Why the world has halted; halted is false while it runs.
typedef struct Blowup {
    bool halted;
    int balloon;    ///< NONE: a ball
    int particle;   ///< loaded number
    long step;      ///< the step in which it was found
    char text[512]; ///< the whole sentence, with the bound that was crossed
} Blowup;

typedef struct World World;

/// Give notice of a verdict about balloon b, or halt where it refuses the step.
void blowup_report(World* world, GuardVerdict verdict, int b);

/// A balloon's step could not be solved, not even in substeps of h: restore the last good state and
/// halt.
void blowup_unsolved(World* world, int balloon, double h);

/// Save the present state as the last good one.
void blowup_save_state(World* world);

/// Whether the present state is bad.
bool blowup_is_bad(const World* world);

/// Restore the last good state.
void blowup_take_back(World* world);

/// The step has gained energy beside what it converted [J], in the shortest substeps too: restore
/// the last good state and halt.
void blowup_gained(World* world, double gain, double turnover);

/// After a step: in a bad state, name it, restore the last good one and halt; in a good state, save
/// it every GUARD_INTERVAL steps.
void blowup_check(World* world);

#endif
