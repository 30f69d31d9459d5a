/// What the overlay says about a world: time, step, pressure, volume, balls, and sentences.
#ifndef BALLOON_VIEW_STATUS_H
#define BALLOON_VIEW_STATUS_H

#include "view/thrower.h"
#include "view/mode.h"
#include "view/overlay.h"
#include "view/picture.h"
#include "world/world.h"

/// What the world does not know of the session around it.
typedef struct Status {
    const Mode* mode;
    const Thrower* thrower; ///< the next ball, said once there are balls; NULL: nobody throws
    int slowdown;           ///< the world runs this many times slower than time
    bool paused;
    const char* compared; ///< what is said of a ghost; "": there is none
    double frame_ms;      ///< wall time of a frame [ms]; 0: not shown
    const char* message;  ///< a sentence for the lower rim; "": none. A blow-up comes first, and
                          ///< a ball that passed through a skin last
} Status;

/// Fill title, rows, message and alarm; the boxes' visibility and the keys are the caller's.
void status_fill(Overlay* overlay, const World* world, const Picture* picture,
                 const Status* status);

#endif
