/// A balloon that has come to rest, and that nothing touches, sleeps: no force on it is computed,
/// and it does not move.
///
///     still    its fastest particle moves less than `rest` of its first size a second
///     asleep   it was still at every check of half a second; its velocities are 0 from then on
///     awake    when its amount of gas changes, a ball may touch it, or the user acts on the world
///
/// Sleep omits the remaining motion: for a motion that decays at the rate r [1/s], a displacement
/// of less than rest / r of the balloon's size. Balloons sleep only in scenes with the key `rest`.
/// The number of checks for which each balloon has been still is part of the state and its hash.
#ifndef BALLOON_WORLD_REST_H
#define BALLOON_WORLD_REST_H

#include "world/blowup.h"

/// Before the substeps of a step: wake the balloons whose amount of gas has changed.
void rest_wake_changed(World* world);

void rest_wake_all(World* world);

/// After every GUARD_INTERVAL steps: check which balloons are still, and let them sleep.
void rest_check(World* world);

#endif
