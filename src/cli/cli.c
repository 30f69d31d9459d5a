/// Reads the command line, calls one verb, prints the one fault.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/crew.h"
#include "base/interrupt.h"
#include "base/memory_missing.h"
#include "base/stream.h"
#include "cli/open.h"
#include "cli/verb.h"
#include "lab/run/result_file.h"
#include "show/keys.h"

#define VERSION "0.1.0"
enum { EXIT_USAGE = 2, EXIT_SIGNAL = 128 }; ///< as shells have them

static void print_help(void) {
    puts("balloon: any quad mesh becomes a rubber balloon\n");
    for (int k = 0; k < verb_count; k++)
        printf("  balloon %-9s %-13s %s\n", verb_table[k].name, verb_table[k].target,
               verb_table[k].about);
    puts("\noptions");
    options_print();
    puts("  --help, --version\n\nkeys");
    keys_print(stdout);
}

/// Whether help or version was asked for, and printed.
static bool print_about(int argc, char** argv) {
    for (int a = 1; a < argc; a++) {
        const bool help = strcmp(argv[a], "--help") == 0;
        if (help)
            print_help();
        else if (strcmp(argv[a], "--version") == 0)
            printf("balloon %s, state of %s\n", VERSION, REAL_NAME);
        else
            continue;
        return true;
    }
    return false;
}

static bool call_verb(const Verb* verb, const Options* options, Fault* fault) {
    double threads;
    if (!options_number(options->threads, "--threads", 1, &threads, fault))
        return false;
    crew_set((int)fmin(threads, CREW_THREADS_MAX));
    result_file_overwrite(options->overwrite);
    const bool good = verb->call(options, fault);
    crew_set(1);
    return good;
}

int cli_main(int argc, char** argv) {
    Options options = {0};
    const Verb* verb;
    Fault fault = {0};
    memory_missing_in_new();
    cli_arguments = argv;
    bool good = print_about(argc, argv);
    if (!good && !options_read(argc, argv, &options, &verb, &fault)) {
        fault_print(&fault, stderr);
        return EXIT_USAGE;
    }
    good = good || call_verb(verb, &options, &fault);
    good = stream_close(stdout, "standard output", &fault) && good;
    if (good)
        return EXIT_SUCCESS;
    fault_print(&fault, stderr);
    return interrupt_signal() ? EXIT_SIGNAL + interrupt_signal() : EXIT_FAILURE;
}
