#include "cli/verb.h"

#include "base/table.h"

// clang-format off
const Verb verb_table[] = {
    {"play",   "[SCENE|MESH]", "open a window and play; the verb may be left out", verb_play, VERB_PLAY},
    {"render", "SCENE|MESH",   "headless frames or a film",                        verb_render, VERB_RENDER},
    {"run",    "SCENE|MESH",   "simulate only, no drawing",                        verb_run, VERB_RUN},
    {"peer",   "SCENE|MESH",   "Bullet's own soft body instead, to compare",       verb_peer, VERB_PEER},
    {"check",  "MESH",         "the mesh doctor; exit 1 if it is unusable",        verb_check, VERB_CHECK},
    {"bench",  "[CASE]",       "measure: all cases, or one",                      verb_bench, VERB_BENCH},
    {"chart",  "[SCENE]",      "speed against accuracy: all scenes, or one",       verb_chart, VERB_CHART},
    {"stability", "",         "where each method fails: maps and limits, to --out",  verb_stability, VERB_STABILITY},
    {"needs",  "[SCENE]",      "what the scene could do without; all: --all", verb_needs, VERB_NEEDS},
    {"advise", "SCENE",        "the cheapest way within --error, or the closest within --budget", verb_advise, VERB_ADVISE},
    {"list",   "",             "scenes, shapes, forces, methods, display modes",   verb_list, VERB_LIST},
    {"keys",   "",             "the scene reference: keys, outputs, input log",    verb_keys, VERB_KEYS},
};
// clang-format on
const int verb_count = sizeof verb_table / sizeof *verb_table;

const Verb* verb_find(const char* name) {
    return table_row_of(verb_table, verb_count, sizeof *verb_table, name);
}
