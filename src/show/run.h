/// `balloon run`: simulate without drawing, and write numbers.
#ifndef BALLOON_SHOW_RUN_H
#define BALLOON_SHOW_RUN_H

#include "show/ghost.h"

/// The first line of a file of skins.
#define RUN_OBJ_MARK "# skins by balloon\n"

typedef struct RunOptions {
    double seconds;     ///< simulated [s]
    double fps;         ///< rows of the CSV per simulated second
    const char* csv;    ///< file for the CSV, "-" for standard output, NULL for none
    const char* obj;    ///< file for the skins at the end, or NULL
    const char* input;  ///< input log to replay, or NULL
    const char* record; ///< file for the session's input log, or NULL
    Ghost* ghost;       ///< a second copy to compare with, or NULL
    bool time;          ///< print the CPU time of stepping alone
    bool report;        ///< print the line of lab/run/report_line.h
    bool quiet;
} RunOptions;

/// Row k of the CSV is the state after floor(k / (fps step)) steps, row 0 the start.
/// Returns false with a fault if a file cannot be read or written, or after a blowup.
bool run(World* world, const RunOptions* options, Fault* fault);

#endif
