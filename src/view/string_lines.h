/// Strings as lines: taut ones straight, slack ones hanging.
#ifndef BALLOON_VIEW_STRING_LINES_H
#define BALLOON_VIEW_STRING_LINES_H

#include "view/picture.h"
#include "world/world.h"

enum {
    STRING_SEGMENTS = 12, ///< lines of a string
    STRING_KNOTS = 2,     ///< balls of a string: at the particle and at the fixed end
};

/// Draw the tied strings of a balloon. A string that would hang below the floor lies on it.
void string_lines_add(Picture* picture, const Balloon* balloon);

/// The same for the tied strings to balloons and knots.
void string_lines_add_joints(Picture* picture, const World* world);

#endif
