#include "contact/things/pins.h"

#include <stdlib.h>

#include "base/array.h"

void pins_add(Pins* pins, Body* body, int particle, Thing* thing) {
    array_reserve(pins->pin, pins->count, pins->capacity);
    pins->pin[pins->count++] = (Pin){body, particle, thing, to_double4(body->x[particle])};
}

bool pins_follow(const Pins* pins) {
    bool woke = false;
    for (int k = 0; k < pins->count; k++) {
        const Pin* pin = &pins->pin[k];
        Body* body = pin->body;
        if (!pin->thing->body.asleep && body->asleep) {
            body_wake(body);
            woke = true;
        }
        body->v[pin->particle] =
            thing_particle_velocity(pin->thing, pin->start, body->x[pin->particle]);
    }
    return woke;
}

Thing* pins_thing(const Pins* pins, const real4* position) {
    for (int k = 0; k < pins->count; k++)
        if (&pins->pin[k].body->x[pins->pin[k].particle] == position)
            return pins->pin[k].thing;
    return NULL;
}

bool pins_are_led(const Pins* pins) {
    for (int k = 0; k < pins->count; k++)
        if (pins->pin[k].thing->path_count > 0)
            return true;
    return false;
}

void pins_close(Pins* pins) {
    free(pins->pin);
    *pins = (Pins){0};
}
