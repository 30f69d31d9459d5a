/// Reads the command line, calls one verb, prints the one fault.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/table.h"
#include "base/crew.h"
#include "cli/open.h"
#include "cli/verb.h"
#include "show/keys.h"

#define VERSION "0.1.0"
enum { EXIT_USAGE = 2 };

typedef struct Verb {
    const char* name;
    const char* target; ///< what it wants, "" for nothing
    const char* about;
    bool (*call)(const Options* options, Fault* fault);
} Verb;

// clang-format off
static const Verb verb_table[] = {
    {"play",   "[SCENE|MESH]", "open a window and play; the verb may be left out", verb_play},
    {"render", "SCENE|MESH",   "headless frames or a film",                        verb_render},
    {"run",    "SCENE|MESH",   "simulate only, no drawing",                        verb_run},
    {"peer",   "SCENE|MESH",   "Bullet's own soft body instead, to compare",       verb_peer},
    {"check",  "MESH",         "the mesh doctor; exit 1 if it is unusable",        verb_check},
    {"bench",  "[CASE]",       "measure: all cases, or one",                      verb_bench},
    {"chart",  "[SCENE]",      "speed against accuracy: all scenes, or one",       verb_chart},
    {"stability", "",         "where each method fails: maps and limits, to --out",  verb_stability},
    {"needs",  "[SCENE]",      "what the scene could do without; all: --all", verb_needs},
    {"advise", "SCENE",        "the cheapest way within --error, or the closest within --budget", verb_advise},
    {"list",   "",             "scenes, shapes, forces, methods, display modes",   verb_list},
    {"keys",   "",             "the scene reference: keys, outputs, input log",    verb_keys},
};
enum { VERBS = sizeof verb_table / sizeof *verb_table };
// clang-format on

static const Verb* find_verb(const char* name) {
    return table_row_of(verb_table, VERBS, sizeof *verb_table, name);
}

static bool is_verb(const char* word) {
    return find_verb(word) != NULL;
}

static void print_help(void) {
    puts("balloon: any quad mesh becomes a rubber balloon\n");
    for (int k = 0; k < VERBS; k++)
        printf("  balloon %-9s %-13s %s\n", verb_table[k].name, verb_table[k].target,
               verb_table[k].about);
    puts("\noptions");
    options_print();
    puts("  --help, --version\n\nkeys");
    keys_print(stdout);
}

int main(int argc, char** argv) {
    for (int a = 1; a < argc; a++) {
        if (strcmp(argv[a], "--help") == 0) {
            print_help();
            return EXIT_SUCCESS;
        }
        if (strcmp(argv[a], "--version") == 0) {
            printf("balloon %s, state of %s\n", VERSION, REAL_NAME);
            return EXIT_SUCCESS;
        }
    }

    cli_arguments = argv;
    Options options = {0};
    const char* word;
    Fault fault = {0};
    if (!options_read(argc, argv, is_verb, &options, &word, &fault)) {
        fault_print(&fault, stderr);
        return EXIT_USAGE;
    }
    double threads;
    bool good = options_number(options.threads, "--threads", 1, &threads, &fault);
    if (good) {
        crew_set((int)fmin(threads, CREW_THREADS_MAX));
        good = (word ? find_verb(word) : &verb_table[0])->call(&options, &fault);
        crew_set(1);
    }
    if (good)
        return EXIT_SUCCESS;
    fault_print(&fault, stderr);
    return EXIT_FAILURE;
}
