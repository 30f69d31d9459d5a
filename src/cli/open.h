/// The world that a command line names, in the precision that its scene asks for.
#ifndef BALLOON_CLI_OPEN_H
#define BALLOON_CLI_OPEN_H

#include "cli/options.h"
#include "lab/advice/advise.h"
#include "show/ghost.h"

extern char** cli_arguments; ///< as main got them, for a hand-over to the other precision

/// The other precision is another program; it reads the same command line again. Returns only with
/// a fault.
bool cli_other_precision(const char* program, Fault* fault);

bool cli_open_advice(const Options* options, AdviseOptions* advise, Fault* fault);

/// The scene's overrides, with those of advice and one more where there is one.
typedef struct Sets {
    SceneSet set[SETS_MOST + OVERRIDES_MOST + 1];
    int count;
    Overrides advised;
    char method[80];
} Sets;

/// Read the scene and open its world.
bool cli_open_world(const Options* options, World* world, Fault* fault);

/// The world, and with --compare its ghost; both are closed by the caller. sets: the world's.
bool cli_open_pair(const Options* options, Sets* sets, World* world, Ghost* ghost, Fault* fault);

#endif
