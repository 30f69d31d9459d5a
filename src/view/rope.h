/// Strings as lines: taut ones straight, slack ones hanging.
#ifndef BALLOON_VIEW_ROPE_H
#define BALLOON_VIEW_ROPE_H

#include "view/picture.h"
#include "world/world.h"

enum {
    ROPE_SEGMENTS = 12, ///< lines that a string is drawn with
    ROPE_KNOTS = 2,     ///< balls: at the particle and at the fixed end
};

/// Draw the tied strings of a balloon; they lie on the floor where they would hang below it.
void rope_take(Picture* picture, const Balloon* balloon);

#endif
