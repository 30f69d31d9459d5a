/// The first camera of a scene: the one that the scene names, or one that sees all of it.
#ifndef BALLOON_VIEW_FRAMING_H
#define BALLOON_VIEW_FRAMING_H

#include "view/camera.h"
#include "world/world.h"

/// The scene's `camera`, or framing_all for a scene without one.
Camera framing_first(const World* world);

/// A camera that sees all balloons, tied strings and nearby balls at their present positions, with
/// a margin for balloons to grow.
Camera framing_all(const World* world);

#endif
