/// Strings as lines: taut ones straight, slack ones hanging.
#ifndef BALLOON_VIEW_STRING_LINES_H
#define BALLOON_VIEW_STRING_LINES_H

#include "view/picture.h"
#include "world/world.h"

enum {
    STRING_SEGMENTS = 12, ///< lines that a string is drawn with
    STRING_KNOTS = 2,     ///< balls: at the particle and at the fixed end
};

/// Draw the tied strings of a balloon; they lie on the floor where they would hang below it.
void string_lines_add(Picture* picture, const Balloon* balloon);

#endif
