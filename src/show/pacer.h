/// Computes how many fixed steps are due in a frame from the elapsed wall time.
///
/// Elapsed time divided by the slow-motion factor becomes steps of the world; the remaining fraction
/// of a step is carried to the next frame. The part of a frame's time beyond `frame_max` is dropped:
/// after an interruption, or on a slow machine, the simulation runs slower and never jumps.
#ifndef BALLOON_SHOW_PACER_H
#define BALLOON_SHOW_PACER_H

#include <stdbool.h>

/// More steps or frames are not counted: a double counts them by ones up to here. [1]
#define PACER_STEPS_MAX 9007199254740992.0

enum { PACER_SLOWEST = 16 }; ///< the lowest speed is 1/16

typedef struct Pacer {
    double step;       ///< h [s] of the world
    double frame_max;  ///< maximum elapsed time of a frame that counts [s]; INFINITY: no maximum
    double world_time; ///< world time since pacer_make [s]
    long steps_due;    ///< steps due since then
    int slowdown;      ///< 1, 2, 4, 8, 16: the world runs this many times slower
    bool paused;
    int single; ///< single steps that the user has requested, due even while paused
} Pacer;

Pacer pacer_make(double step, double frame_max);

/// Steps due after a frame that took `elapsed` seconds of wall time. They count as made: a caller
/// that runs out of time drops them.
long pacer_due(Pacer* pacer, double elapsed);

void pacer_slower(Pacer* pacer);
void pacer_faster(Pacer* pacer);

/// Number of steps in `time`, rounded down; a quotient below a whole number by a rounding error is
/// rounded up.
long pacer_steps(double time, double step);

#endif
