/// Runs of `balloon run` within limits of CPU time and memory, classified by how they end, for
/// benches with scenes that the program may be unable to step.
///
/// After `cpu` seconds of CPU time the run is asked to end, and prints how far it came; after twice
/// that time it is killed. A run may end with exit status 0 and finite numbers, or with another
/// status and a sentence; every other ending is wrong.
#ifndef BALLOON_LAB_RUN_BOUNDED_RUN_H
#define BALLOON_LAB_RUN_BOUNDED_RUN_H

#include "lab/run/report.h"

typedef enum Ending {
    ENDING_GOOD,    ///< exit status 0 and finite numbers
    ENDING_STOPPED, ///< a sentence after steps: a blowup
    ENDING_REFUSED, ///< a sentence before the first step
    ENDING_LONG,    ///< a sentence at the limit of CPU time
    ENDING_WRONG,   ///< a signal, no end, no sentence, or a number that is not finite
    ENDINGS
} Ending;
extern const char* const ending_name[ENDINGS];

enum { ENDING_TEXT = 400 };

/// A run of `program` on a scene for `seconds` of simulated time [s], with the state at its start
/// and at the ends of `rows` equal parts of it in its CSV, within `cpu` seconds of CPU time [s].
/// Overrides may be added.
void bounded_run(Launch* launch, const char* program, const char* scene, double seconds, int rows,
                 double cpu);

/// How a run ended; text: its sentence, or what is wrong with it.
Ending bounded_run_ending(const Launch* launch, const Report* report, char text[ENDING_TEXT]);

/// Print the command line, quoted for a shell.
void bounded_run_print(const Launch* launch, FILE* out);

#endif
