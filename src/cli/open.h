/// Opens the world of a command line, in the precision that its scene names.
#ifndef BALLOON_CLI_OPEN_H
#define BALLOON_CLI_OPEN_H

#include "cli/options.h"
#include "lab/advice/advise.h"
#include "show/ghost.h"

extern char** cli_arguments; ///< argv of main, for the program of the other precision

/// Replace the process by the program of the other precision, with the same command line. Returns
/// only with a fault.
bool cli_other_precision(const char* program, Fault* fault);

/// The options of `balloon advise`.
bool cli_open_advice(const Options* options, AdviseOptions* advise, Fault* fault);

/// All overrides of a scene: those of the command line, of advice, and of a ghost's method.
typedef struct Sets {
    SceneSet set[MAX_SETS + MAX_OVERRIDES + 1];
    int count;
    Overrides advised;
    char method[80];
} Sets;

/// Load the scene and open its world.
bool cli_open_world(const Options* options, World* world, Fault* fault);

/// Open the world and, with --compare, its ghost; the caller closes both. sets: receives the world's
/// overrides.
/// The simulated time and the frames or rows per second that the options ask for. More steps or
/// frames than can be counted are refused.
bool cli_times(const Options* options, const World* world, double* seconds, double* fps,
               Fault* fault);

bool cli_open_pair(const Options* options, Sets* sets, World* world, Ghost* ghost, Fault* fault);

#endif
