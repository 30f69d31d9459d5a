#include "cli/options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// An option sets a text or a flag of Options, or is short for `--set key=VALUE`.
typedef struct Option {
    const char* name;
    const char* value; ///< name of its value in the help; NULL: a flag
    const char* about;
    size_t text;     ///< offset of a const char* in Options
    size_t flag;     ///< offset of a bool in Options
    const char* key; ///< key of the scene that it sets; "": the value names the key
    const char* old; ///< earlier name, still read; NULL: none
} Option;

#define TEXT(field) .text = offsetof(Options, field)
#define FLAG(field) .flag = offsetof(Options, field)

// clang-format off
static const Option option_table[] = {
    {"--seconds",   "T",        "simulated time; default: the scene's, or 10",     TEXT(seconds)},
    {"--fps",       "N",        "frames or CSV rows per simulated second; 60",     TEXT(fps)},
    {"--size",      "WxH",      "of the pictures; 1280x720",                       TEXT(size)},
    {"--out",       "PATH",     "render: a folder for frames, or a .png, .mp4, .webm, .gif; out", TEXT(out)},
    {"--mode",      "NAME",     "display mode; see balloon list",                  TEXT(mode)},
    {"--overlay",   NULL,       "render: pictures with the status box",            FLAG(overlay)},
    {"--lab",       NULL,       "play, render: pictures with the lab's panel",     FLAG(lab)},
    {"--input",     "FILE",     "replay an input log",                             TEXT(input)},
    {"--record",    "FILE",     "write the session's input log",                   TEXT(record)},
    {"--csv",       "FILE",     "numbers, one row a frame; - for standard output", TEXT(csv)},
    {"--mesh",      "FILE",     "the skins at the end, as .obj",                   TEXT(mesh), .old = "--obj"},
    {"--hash",      NULL,       "print the hash of the state at the end",          FLAG(hash)},
    {"--time",      NULL,       "print the CPU time of stepping, or of a frame's stages",           FLAG(time)},
    {"--report",    NULL,       "run, peer: one last line of KEY=VALUE, for programs", FLAG(report)},
    {"--quiet",     NULL,       "say nothing but results and faults",              FLAG(quiet)},
    {"--threads",   "N",        "threads that share a step, same bits; 1",         TEXT(threads)},
    {"--keep",      NULL,       "bench: keep these figures, to compare later ones with", FLAG(keep)},
    {"--only",      "WORD",     "bench table1: the models with it in their names", TEXT(only)},
    {"--quick",     NULL,       "bench, chart, stability, needs: a thinned measurement",  FLAG(quick)},
    {"--all",       NULL,       "chart: every point there is; needs: every scene",                    FLAG(all)},
    {"--fit",       "P,V[,S]|K","peer: links that rest at V first volumes under P [Pa], at step S; or as springs of K", TEXT(fit)},
    {"--compare",   "METHOD",   "a second copy of the scene by that method, as a ghost", TEXT(compare)},
    {"--error",     "E",        "advise: how far off it may be, as 1%",            TEXT(error)},
    {"--budget",    "T",        "advise: what a frame may cost, as 4ms",           TEXT(budget)},
    {"--fresh",     NULL,       "advise: measure this machine again",              FLAG(fresh)},
    {"--auto",      NULL,       "play, render, run: as advise says; 8ms if nobody says", FLAG(advised)},
    {"--method",    "NAME",     "how to step; see balloon list",                   .key = "method"},
    {"--step",      "S",        "length of a step [s]",                            .key = "step"},
    {"--guard",     "split|stop|off", "what to do with a step that is too long",   .key = "guard"},
    {"--precision", "float|double",   "of the state",                              .key = "precision"},
    {"--set",       "KEY=VALUE", "any key of the scene, as in balloons.0.inflation.amount=10", .key = ""},
};
enum { OPTIONS = sizeof option_table / sizeof *option_table };
// clang-format on

void options_print(void) {
    for (int k = 0; k < OPTIONS; k++)
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

/// The row of an option's name; an earlier name is read with a sentence on stderr.
static const Option* find_option(const char* name, size_t length) {
    for (int k = 0; k < OPTIONS; k++) {
        if (is_named(option_table[k].name, name, length))
            return &option_table[k];
        if (is_named(option_table[k].old, name, length)) {
            fprintf(stderr, "balloon: %s is now %s\n", option_table[k].old, option_table[k].name);
            return &option_table[k];
        }
    }
    return NULL;
}

bool options_read(int argc, char** argv, bool (*is_verb)(const char* word), Options* options,
                  const char** verb, Fault* fault) {
    *verb = NULL;
    for (int a = 1; a < argc; a++) {
        const char* word = argv[a];
        if (strncmp(word, "--", 2) == 0) {
            const char* equals = strchr(word, '=');
            const size_t length = equals ? (size_t)(equals - word) : strlen(word);
            const Option* option = find_option(word, length);
            if (!option)
                return fault_set(fault, word, "no such option; see balloon --help");
            if (option->value && !equals && a + 1 == argc)
                return fault_set(fault, word, "needs a value: %s", option->value);
            if (!option->value && equals)
                return fault_set(fault, word, "takes no value");
            const char* value = !option->value ? NULL : equals ? equals + 1 : argv[++a];
            if (!apply_option(options, option, value, fault))
                return false;
            continue;
        }
        if (!*verb && !options->target && is_verb(word)) {
            *verb = word;
            continue;
        }
        if (options->target)
            return fault_set(fault, word, "only one scene or mesh at a time");
        options->target = word;
    }
    return true;
}
