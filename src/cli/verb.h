/// The verbs of `balloon VERB`: a table, with a function for each.
#ifndef BALLOON_CLI_VERB_H
#define BALLOON_CLI_VERB_H

#include "cli/options.h"

/// A bit for each verb, by which an option names its readers.
enum {
    VERB_PLAY = 1 << 0,
    VERB_RENDER = 1 << 1,
    VERB_RUN = 1 << 2,
    VERB_PEER = 1 << 3,
    VERB_CHECK = 1 << 4,
    VERB_BENCH = 1 << 5,
    VERB_CHART = 1 << 6,
    VERB_STABILITY = 1 << 7,
    VERB_NEEDS = 1 << 8,
    VERB_ADVISE = 1 << 9,
    VERB_LIST = 1 << 10,
    VERB_KEYS = 1 << 11,
    VERBS_ALL = (1 << 12) - 1,
};

typedef struct Verb {
    const char* name;
    const char* target; ///< what it wants, "" for nothing
    const char* about;
    bool (*call)(const Options* options, Fault* fault);
    unsigned bit;
} Verb;

extern const Verb verb_table[]; ///< the first row is the one without a name on the command line
extern const int verb_count;

/// Row by name, or NULL.
const Verb* verb_find(const char* name);

/// Do what the command line says and print the one fault; returns the exit status. In cli.c.
int cli_main(int argc, char** argv);

// verb_show.c
bool verb_play(const Options* options, Fault* fault);
bool verb_render(const Options* options, Fault* fault);
bool verb_run(const Options* options, Fault* fault);

// verb_lab.c
bool verb_peer(const Options* options, Fault* fault);
bool verb_bench(const Options* options, Fault* fault);
bool verb_stability(const Options* options, Fault* fault);
bool verb_chart(const Options* options, Fault* fault);
bool verb_needs(const Options* options, Fault* fault);
bool verb_advise(const Options* options, Fault* fault);

// verb_list.c
bool verb_check(const Options* options, Fault* fault);
bool verb_list(const Options* options, Fault* fault);
bool verb_keys(const Options* options, Fault* fault);

#endif
