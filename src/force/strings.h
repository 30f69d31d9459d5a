/// The tension of strings.
#ifndef BALLOON_FORCE_STRINGS_H
#define BALLOON_FORCE_STRINGS_H

#include "body/body.h"

/// Tension of string number `string` at the present positions [N].
double string_tension(const Body* body, int string);

/// Lengthen a string that is tied again to where its particle is now:
///
///     free length >= distance to the anchor - stretch when it was first tied
///
/// With its old length, a string of 50 N/m to a balloon that flew 80 m away would pull one particle
/// of a gram with 4 kN.
void string_reach(const Body* body, String* string);

#endif
