/// The overlay's text about a world: time, step, pressure, volume, balls, and messages.
#ifndef BALLOON_VIEW_STATUS_H
#define BALLOON_VIEW_STATUS_H

#include "view/thrower.h"
#include "view/mode.h"
#include "view/overlay.h"
#include "view/picture.h"
#include "world/world.h"

/// The state of the program around the world.
typedef struct Status {
    const Mode* mode;
    const Thrower* thrower; ///< the next ball, printed once there are balls; NULL: none
    int slowdown;           ///< the world runs this many times slower than wall time
    bool paused;
    const char* compared; ///< text about the ghost; "": there is none
    double frame_ms;      ///< wall time of a frame [ms]; 0: no row
    const char* message;  ///< a message to the user; "": none. A blowup precedes it, a pass-through
                          ///< follows it
} Status;

/// Fill title, rows, message and alarm; the boxes' visibility and the keys are the caller's.
void status_fill(Overlay* overlay, const World* world, const Picture* picture,
                 const Status* status);

#endif
