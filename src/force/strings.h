/// The tension of strings.
#ifndef BALLOON_FORCE_STRINGS_H
#define BALLOON_FORCE_STRINGS_H

#include "body/body.h"

/// Tension of string number `string` at the present positions [N].
double string_tension(const Body* body, int string);

/// Lengthen a string that is tied again to where its particle is now (string_tied_length).
void string_reach(const Body* body, String* string);

#endif
