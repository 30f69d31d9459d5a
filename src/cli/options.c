#include "cli/options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/table.h"
#include "cli/verb.h"

#define TEXT(field) .text = offsetof(Options, field)
#define FLAG(field) .flag = offsetof(Options, field)

/// Verbs that read the same options.
enum {
    SHOWS = VERB_PLAY | VERB_RENDER,
    SESSIONS = SHOWS | VERB_RUN,
    RUNS = SESSIONS | VERB_PEER,
    SCENES = RUNS | VERB_NEEDS | VERB_ADVISE,
    OUTS = VERB_RENDER | VERB_BENCH | VERB_CHART | VERB_STABILITY | VERB_NEEDS | VERB_ADVISE,
};

// clang-format off
const Option option_table[] = {
    {"--seconds",   "T",        "simulated time; default: the scene's, or 10", RUNS, TEXT(seconds)},
    {"--fps",       "N",        "frames or CSV rows per simulated second; 60", RUNS, TEXT(fps)},
    {"--size",      "WxH",      "of the pictures; 1280x720", SHOWS, TEXT(size)},
    {"--out",       "PATH",     "render: a folder for frames, or a .png, .mp4, .webm, .gif; out", OUTS, TEXT(out)},
    {"--mode",      "NAME",     "display mode; see balloon list", SHOWS, TEXT(mode)},
    {"--overlay",   NULL,       "render: pictures with the status box", VERB_RENDER, FLAG(overlay)},
    {"--lab",       NULL,       "play, render: pictures with the lab's panel", SHOWS, FLAG(lab)},
    {"--input",     "FILE",     "replay an input log", SESSIONS, TEXT(input)},
    {"--record",    "FILE",     "write the session's input log", SESSIONS, TEXT(record)},
    {"--csv",       "FILE",     "numbers, one row a frame; - for standard output", VERB_RUN | VERB_PEER, TEXT(csv)},
    {"--mesh",      "FILE",     "the skins at the end, as .obj", VERB_RUN, TEXT(mesh), .old = "--obj"},
    {"--hash",      NULL,       "print the hash of the state at the end", RUNS, FLAG(hash)},
    {"--time",      NULL,       "print the CPU time of stepping, or of a frame's stages", RUNS, FLAG(time)},
    {"--report",    NULL,       "run, peer: one last line of KEY=VALUE, for programs; advise: the overrides", VERB_RUN | VERB_PEER | VERB_ADVISE, FLAG(report)},
    {"--quiet",     NULL,       "say nothing but results and faults", RUNS, FLAG(quiet)},
    {"--threads",   "N",        "threads that share a step, same bits; 1", VERBS_ALL, TEXT(threads)},
    {"--keep",      NULL,       "bench: keep these figures, to compare later ones with", VERB_BENCH, FLAG(keep)},
    {"--only",      "WORD",     "bench table1, guard: rows with it in their names; scenes, encounters: a seed, or 0-499", VERB_BENCH, TEXT(only)},
    {"--quick",     NULL,       "bench, chart, stability, needs: a thinned measurement", VERB_BENCH | VERB_CHART | VERB_STABILITY | VERB_NEEDS, FLAG(quick)},
    {"--all",       NULL,       "chart: every point there is; needs: every scene", VERB_CHART | VERB_NEEDS, FLAG(all)},
    {"--overwrite", NULL,       "write over files that balloon did not make, or that it reads", SESSIONS | OUTS, FLAG(overwrite)},
    {"--fit",       "P,V[,S]|K","peer: links fitted to rest at V times the first volume under pressure P [Pa], with steps of S [s]; or of the stiffness K [N/m]", VERB_PEER, TEXT(fit)},
    {"--compare",   "METHOD",   "a second copy of the scene by that method, as a ghost", SESSIONS, TEXT(compare)},
    {"--error",     "E",        "advise, --auto: largest error, as 1%", SESSIONS | VERB_ADVISE, TEXT(error)},
    {"--budget",    "T",        "advise, --auto: CPU time of a frame, as 4ms", SESSIONS | VERB_ADVISE, TEXT(budget)},
    {"--fresh",     NULL,       "advise: measure this machine again", SESSIONS | VERB_ADVISE, FLAG(fresh)},
    {"--auto",      NULL,       "play, render, run: the method that advise finds, within --error or --budget; by default 8ms a frame", SESSIONS, FLAG(advised)},
    {"--method",    "NAME",     "how to step; see balloon list", SCENES, .key = "method"},
    {"--step",      "S",        "length of a step [s]", SCENES, .key = "step"},
    {"--guard",     "split|stop|off", "what to do with a step that is too long", SCENES, .key = "guard"},
    {"--precision", "float|double",   "of the state", SCENES, .key = "precision"},
    {"--set",       "KEY=VALUE", "any key of the scene, as in balloons.0.inflation.amount=10", SCENES, .key = ""},
};
// clang-format on
const int option_count = sizeof option_table / sizeof *option_table;

void options_print(void) {
    for (int k = 0; k < option_count; k++)
        printf("  %-11s %-14s  %s\n", option_table[k].name,
               option_table[k].value ? option_table[k].value : "", option_table[k].about);
}

bool options_number(const char* text, const char* option, double fallback, double* value,
                    Fault* fault) {
    char* end;
    *value = text ? strtod(text, &end) : fallback;
    if (text && (end == text || *end || !isfinite(*value) || *value <= 0))
        return fault_set(fault, option, "'%s' is not a number above 0", text);
    return true;
}

bool options_quantity(const char* text, const char* option, const char* unit, double of_unit,
                      double* value, Fault* fault) {
    char* end;
    *value = text ? strtod(text, &end) : 0;
    const bool has_unit = text && end > text && strcmp(end, unit) == 0;
    if (text && (end == text || (*end && !has_unit) || !isfinite(*value) || *value <= 0))
        return fault_set(fault, option, "'%s' is not a number above 0, as in 4%s", text, unit);
    *value *= has_unit ? of_unit : 1;
    return true;
}

static bool apply_option(Options* options, const Option* option, const char* value, Fault* fault) {
    if (option->key) {
        if (options->set_count == MAX_SETS)
            return fault_set(fault, option->name, "at most %d of these", MAX_SETS);
        char* typed = options->typed[options->set_count];
        const char* text = value;
        if (option->key[0]) {
            snprintf(typed, sizeof *options->typed, "%s=%s", option->key, value);
            text = typed;
        }
        options->set[options->set_count++].text = text;
    } else if (option->value) {
        *(const char**)((char*)options + option->text) = value;
    } else {
        *(bool*)((char*)options + option->flag) = true;
    }
    return true;
}

static bool is_named(const char* option, const char* name, size_t length) {
    return option && strlen(option) == length && strncmp(option, name, length) == 0;
}

const char* options_short_for(const char* key, size_t length) {
    for (int k = 0; k < option_count; k++)
        if (is_named(option_table[k].key, key, length))
            return option_table[k].name;
    return NULL;
}

/// The row of an option's name; an earlier name is read with a sentence on stderr.
static const Option* find_option(const char* name, size_t length) {
    for (int k = 0; k < option_count; k++) {
        if (is_named(option_table[k].name, name, length))
            return &option_table[k];
        if (is_named(option_table[k].old, name, length)) {
            fprintf(stderr, "balloon: %s is now %s\n", option_table[k].old, option_table[k].name);
            return &option_table[k];
        }
    }
    return NULL;
}

/// What an option's argument says of its row: the row, or NULL with a fault. *a: its index, that of
/// its value afterwards.
static const Option* read_option(int argc, char** argv, int* a, Options* options, Fault* fault) {
    const char* word = argv[*a];
    const char* equals = strchr(word, '=');
    const size_t length = equals ? (size_t)(equals - word) : strlen(word);
    const Option* option = find_option(word, length);
    bool good = true;
    if (!option)
        good = fault_set(fault, word, "no such option; see balloon --help");
    else if (option->value && !equals && *a + 1 == argc)
        good = fault_set(fault, word, "needs a value: %s", option->value);
    else if (!option->value && equals)
        good = fault_set(fault, word, "takes no value");
    if (!good)
        return NULL;
    const char* value = !option->value ? NULL : equals ? equals + 1 : argv[++*a];
    if (value && !value[0]) {
        fault_set(fault, option->name, "needs a value: %s", option->value);
        return NULL;
    }
    return apply_option(options, option, value, fault) ? option : NULL;
}

/// Whether the verb reads each of these options.
static bool verb_reads(const Verb* verb, const bool* used, Fault* fault) {
    for (int k = 0; k < option_count; k++) {
        char names[200] = "";
        if (!used[k] || option_table[k].verbs & verb->bit)
            continue;
        for (int v = 0; v < verb_count; v++)
            if (option_table[k].verbs & verb_table[v].bit)
                table_add_name(names, sizeof names, verb_table[v].name);
        return fault_set(fault, option_table[k].name, "not an option of %s; of %s", verb->name,
                         names);
    }
    return true;
}

bool options_read(int argc, char** argv, Options* options, const Verb** verb, Fault* fault) {
    bool used[sizeof option_table / sizeof *option_table] = {false};
    *verb = NULL;
    for (int a = 1; a < argc; a++) {
        if (strncmp(argv[a], "--", 2) == 0) {
            const Option* option = read_option(argc, argv, &a, options, fault);
            if (!option)
                return false;
            used[option - option_table] = true;
        } else if (!*verb && !options->target && verb_find(argv[a])) {
            *verb = verb_find(argv[a]);
        } else if (options->target && *verb) {
            return fault_set(fault, argv[a], "only one scene or mesh at a time");
        } else if (options->target) {
            return fault_set(fault, argv[a],
                             "only one scene or mesh at a time; if '%s' is to be a verb, there is "
                             "none of that name, see balloon --help",
                             options->target);
        } else {
            options->target = argv[a];
        }
    }
    if (!*verb)
        *verb = &verb_table[0];
    return verb_reads(*verb, used, fault);
}
