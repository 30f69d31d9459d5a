/// A balloon that has come to rest, and that nothing moves, sleeps: it costs no force and does not move.
///
///     still    its fastest particle moves less than `sleep_threshold` of its first size a second
///     asleep   it and its island of contacts were still at every check of half a second; its
///              velocities are 0 from then on
///     awake    when its amount of gas changes, a ball or an awake balloon may touch it, or the user acts
///
/// Sleep omits a displacement of less than sleep_threshold / r of the balloon's size, for a motion that
/// decays at the rate r [1/s]. Balloons sleep only in scenes with the key `sleep_threshold`. The checks for which
/// each has been still are part of the state and its hash.
#ifndef BALLOON_WORLD_REST_H
#define BALLOON_WORLD_REST_H

#include "world/guard/blowup.h"

/// Before the substeps of a step: wake the balloons whose amount of gas has changed.
void rest_wake_changed(World* world);

void rest_wake_all(World* world);

/// After every GUARD_INTERVAL steps: check which balloons are still, and let them sleep.
void rest_check(World* world);

#endif
