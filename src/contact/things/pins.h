/// Pins: particles of skins that things hold. They have no equation of their own, move as a point of
/// the thing does, and what pulls on them pulls on the thing.
#ifndef BALLOON_CONTACT_THINGS_PINS_H
#define BALLOON_CONTACT_THINGS_PINS_H

#include "contact/things/thing.h"

typedef struct Pin {
    Body* body;
    int particle; ///< held: of inverse mass 0
    Thing* thing;
    double4 start; ///< its position at the start [m]
} Pin;

typedef struct Pins {
    Pin* pin; ///< [count]
    int count, capacity;
} Pins;

void pins_add(Pins* pins, Body* body, int particle, Thing* thing);

/// Give all pinned particles the velocities of their things. Returns whether a skin has woken.
bool pins_follow(const Pins* pins);

/// The thing that holds the particle of this position in its body's array; NULL: none.
Thing* pins_thing(const Pins* pins, const real4* position);

/// Whether a thing on a path holds any.
bool pins_are_led(const Pins* pins);

void pins_close(Pins* pins);

#endif
