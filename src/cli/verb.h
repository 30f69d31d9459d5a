/// The verbs of `balloon VERB`; their table is in main.c.
#ifndef BALLOON_CLI_VERB_H
#define BALLOON_CLI_VERB_H

#include "cli/options.h"

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
