/// The command line: a table of options, each of which sets a field of Options or is short for
/// `--set key=VALUE`. An option that the verb does not read is refused.
#ifndef BALLOON_CLI_OPTIONS_H
#define BALLOON_CLI_OPTIONS_H

#include <stddef.h>

#include "scene/scene.h"

enum { MAX_SETS = 64 };

/// The options of all verbs.
typedef struct Options {
    const char* target; ///< scene or mesh
    const char* seconds;
    const char* fps;
    const char* size;
    const char* out;
    const char* input;
    const char* record;
    const char* csv;
    const char* mesh;
    const char* mode;
    const char* fit;
    const char* threads;
    const char* compare;
    const char* error;
    const char* budget;
    const char* only;
    bool hash, time, report, quiet, overlay, lab, keep, quick, all, fresh, advised, overwrite;
    SceneSet set[MAX_SETS];
    int set_count;
    char typed[MAX_SETS][256]; ///< texts of the overrides that options such as --step are short for
} Options;

/// An option sets a text or a flag of Options, or is short for `--set key=VALUE`.
typedef struct Option {
    const char* name;
    const char* value; ///< name of its value in the help; NULL: a flag
    const char* about;
    unsigned verbs;  ///< that read it: their bits (cli/verb.h)
    size_t text;     ///< offset of a const char* in Options
    size_t flag;     ///< offset of a bool in Options
    const char* key; ///< key of the scene that it sets; "": the value names the key
    const char* old; ///< earlier name, still read; NULL: none
} Option;

extern const Option option_table[];
extern const int option_count;

struct Verb; // cli/verb.h

/// Read options, "--key value" or "--key=value", at any position; the other words are verb and
/// target. The verb is play if the first word is none. Texts point into argv.
bool options_read(int argc, char** argv, Options* options, const struct Verb** verb, Fault* fault);

void options_print(void);

/// Name of the option that is short for `--set key=VALUE`, or NULL.
const char* options_short_for(const char* key, size_t length);

/// A number above 0 from an option's text; `fallback` without a text.
bool options_number(const char* text, const char* option, double fallback, double* value,
                    Fault* fault);

/// A number above 0 with or without a unit: "1%", "0.01", "4ms". of_unit: factor of the unit; 0
/// without a text.
bool options_quantity(const char* text, const char* option, const char* unit, double of_unit,
                      double* value, Fault* fault);

#endif
