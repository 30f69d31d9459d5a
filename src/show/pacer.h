/// Decides how many fixed steps are due in a frame, from the wall time that has passed.
///
/// Time that has passed, over the slow-motion factor, becomes steps of the world; the fraction of a
/// step that is left waits for the next frame. Time beyond `frame_max` of a single
/// frame is dropped: after a hitch, or on a slow machine, the simulation runs slower and never
/// jumps.
#ifndef BALLOON_SHOW_PACER_H
#define BALLOON_SHOW_PACER_H

#include <stdbool.h>

enum { PACER_SLOWEST = 16 }; ///< least speed is 1/16

typedef struct Pacer {
    double step;       ///< h [s] of the world
    double frame_max;  ///< of a frame's time that counts [s]; INFINITY: all of it
    double world_time; ///< world time that has passed since it was made [s]
    long steps_due;    ///< steps handed out since then
    int slowdown;      ///< 1, 2, 4, 8, 16: the world runs this many times slower
    bool paused;
    int single; ///< steps asked for by hand, which are due even while paused
} Pacer;

Pacer pacer_make(double step, double frame_max);

/// Steps due after a frame that took `elapsed` seconds of wall time. They count as made: a caller that
/// runs out of time drops the rest.
long pacer_due(Pacer* pacer, double elapsed);

void pacer_slower(Pacer* pacer);
void pacer_faster(Pacer* pacer);

/// How many steps fit into `time`: rounded down, but up where it misses a whole
/// number by a rounding error.
long pacer_steps(double time, double step);

#endif
