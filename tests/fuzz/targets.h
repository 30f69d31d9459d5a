/// Readers of files and of the command line, as functions of arbitrary bytes: each must return on
/// any input. libFuzzer searches for bytes with which one does not (make fuzz); unit/test_fuzz.c
/// replays the stored inputs, a folder for each target in fuzz/corpus.
#ifndef BALLOON_FUZZ_TARGETS_H
#define BALLOON_FUZZ_TARGETS_H

#include <stdint.h>
#include <string.h>
#include <unistd.h>

#include "cli/options.h"
#include "cli/verb.h"
#include "mesh/load.h"
#include "scene/scene.h"
#include "world/record.h"

enum { WORDS_MAX = 16 }; ///< overrides or arguments

/// A file with these bytes; the reader looks at the ending.
static void fuzz_file(const uint8_t* data, size_t size, const char* ending, char path[64]) {
    snprintf(path, 64, "/tmp/fuzz-%ld%s", (long)getpid(), ending);
    FILE* out = fopen(path, "wb");
    ASSERT(out && fwrite(data, 1, size, out) == size && fclose(out) == 0, "a scratch file");
}

static void fuzz_mesh_of(const uint8_t* data, size_t size, const char* ending) {
    char path[64];
    Mesh mesh = {0};
    MeshReport report = {0};
    Fault fault = {0};
    fuzz_file(data, size, ending, path);
    if (mesh_load(path, &mesh, &report, &fault))
        mesh_free(&mesh);
    else
        ASSERT(fault.text[0], "what is refused is explained");
    remove(path);
}

static void fuzz_mesh(const uint8_t* data, size_t size) {
    fuzz_mesh_of(data, size, ".obj");
}

static void fuzz_scene(const uint8_t* data, size_t size) {
    char path[64];
    WorldDef def;
    Fault fault = {0};
    fuzz_file(data, size, ".yaml", path);
    if (scene_load(path, NULL, 0, &def, &fault))
        scene_free(&def);
    else
        ASSERT(fault.text[0], "what is refused is explained");
    remove(path);
}

static void fuzz_input(const uint8_t* data, size_t size) {
    char path[64];
    Record record;
    Fault fault = {0};
    fuzz_file(data, size, ".log", path);
    if (record_load(path, &record, &fault))
        record_free(&record);
    else
        ASSERT(fault.text[0], "what is refused is explained");
    remove(path);
}

/// The lines of the bytes, as words. text: freed by the caller.
static int fuzz_words(const uint8_t* data, size_t size, char** text, char* word[WORDS_MAX]) {
    int count = 0;
    *text = calloc(size + 1, 1);
    ASSERT(*text, "memory");
    memcpy(*text, data, size);
    for (char* at = *text; count < WORDS_MAX && at < *text + size; at += strlen(at) + 1) {
        at[strcspn(at, "\n")] = '\0';
        word[count++] = at;
    }
    return count;
}

static void fuzz_set(const uint8_t* data, size_t size) {
    char *text, *word[WORDS_MAX];
    SceneSet set[WORDS_MAX] = {{0}};
    WorldDef def;
    Fault fault = {0};
    const int count = fuzz_words(data, size, &text, word);
    for (int k = 0; k < count; k++)
        set[k].text = word[k];
    if (scene_load("cube", set, count, &def, &fault))
        scene_free(&def);
    else
        ASSERT(fault.text[0], "what is refused is explained");
    free(text);
}

static void fuzz_command(const uint8_t* data, size_t size) {
    char *text, *argument[WORDS_MAX + 2] = {(char*)"balloon"};
    Options options = {0};
    const Verb* verb;
    Fault fault = {0};
    double number;
    const int count = fuzz_words(data, size, &text, argument + 1);
    if (!options_read(count + 1, argument, &options, &verb, &fault))
        ASSERT(fault.text[0], "what is refused is explained");
    fault = (Fault){0};
    options_number(options.seconds, "--seconds", 1, &number, &fault);
    options_quantity(options.error, "--error", "%", 0.01, &number, &fault);
    free(text);
}

static const struct FuzzTarget {
    const char* name;
    void (*run)(const uint8_t* data, size_t size);
} fuzz_table[] = {
    {"mesh", fuzz_mesh}, {"scene", fuzz_scene},     {"input", fuzz_input},
    {"set", fuzz_set},   {"command", fuzz_command},
};
enum { FUZZ_TARGETS = sizeof fuzz_table / sizeof *fuzz_table };

#endif
