/// Runs of `balloon run` within limits of CPU time and memory, classed by how they end: benches of
/// what the program says where a scene is beyond it.
///
/// A run asks for its end after `cpu` seconds, and says how far it was; it is ended where it does
/// not answer in as long again. Right ends are numbers that are finite, with exit status 0, and a
/// sentence with another status; every other one is wrong.
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

/// A run of `program` on a scene for `seconds` of simulated time [s], with the state at its start and
/// at the ends of `rows` equal parts of it in its CSV, within `cpu` seconds of CPU time [s].
/// Overrides may be added.
void bounded_run(Launch* launch, const char* program, const char* scene, double seconds, int rows,
                 double cpu);

/// How a run ended, and what it said, or what is wrong with it.
Ending bounded_run_ending(const Launch* launch, const Report* report, char text[ENDING_TEXT]);

/// Print the command line, as a shell reads it.
void bounded_run_print(const Launch* launch, FILE* out);

#endif
