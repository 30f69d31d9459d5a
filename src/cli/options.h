/// What the command line says: a table of options, each of which fills a field of Options or stands
/// for `--set key=VALUE`.
#ifndef BALLOON_CLI_OPTIONS_H
#define BALLOON_CLI_OPTIONS_H

#include "scene/scene.h"

enum { SETS_MOST = 64 };

/// Everything that the command line can say.
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
    bool hash, time, report, quiet, overlay, lab, keep, quick, all, fresh, advised;
    SceneSet set[SETS_MOST];
    int set_count;
    char typed[SETS_MOST][256]; ///< texts of the sets that options such as --step stand for
} Options;

/// Options in any place, "--key value" or "--key=value"; the words left are verb and target. verb:
/// the first word if is_verb says so, else NULL. texts: they point into argv.
bool options_read(int argc, char** argv, bool (*is_verb)(const char* word), Options* options,
                  const char** verb, Fault* fault);

void options_print(void);

/// A number above 0 from an option's text, `fallback` where there is none.
bool options_number(const char* text, const char* option, double fallback, double* value,
                    Fault* fault);

/// "1%", "0.01" or "4ms": a number and its unit, which is worth of_unit; 0 where there is no text.
bool options_quantity(const char* text, const char* option, const char* unit, double of_unit,
                      double* value, Fault* fault);

#endif
