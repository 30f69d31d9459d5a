/// A balloon that has come to rest, and that nothing touches, sleeps: no force on it is computed,
/// and it does not move.
///
///     still    its fastest particle goes less than `rest` of its first sizes a second
///     asleep   it was still at every look of half a second; its velocities are 0 from then on
///     awake    when its amount of gas changes, a ball may touch it, or anyone acts on the world
///
/// What sleep leaves out is the way that was left to go: of a motion that dies out at a rate of r
/// [1/s], less than rest / r of the balloon's size. Only a scene that names `rest` has sleepers.
/// Who sleeps, and how long the others have been still, is part of the state and of its hash.
#ifndef BALLOON_WORLD_REST_H
#define BALLOON_WORLD_REST_H

#include "world/blowup.h"

/// Before the parts of a step: wake those whose amount of gas has changed.
void rest_wake_changed(World* world);

void rest_wake_all(World* world);

/// After a step: look who is still, every GUARD_INTERVAL steps.
void rest_look(World* world);

#endif
