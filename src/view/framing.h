/// Where the eye stands at first: where the scene says, else where all of it is in sight.
#ifndef BALLOON_VIEW_FRAMING_H
#define BALLOON_VIEW_FRAMING_H

#include "view/camera.h"
#include "world/world.h"

/// The scene's `camera`, or framing_all where it has none.
Camera framing_first(const World* world);

/// All balloons, tied strings and balls that are near them as they are now, with room to grow.
Camera framing_all(const World* world);

#endif
