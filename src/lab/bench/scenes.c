/// Random scenes: shipped ones with one to three values drawn at random over their whole ranges, as
/// a user might mistype them. Each runs for a short time within limits of CPU time and memory, and
/// must end with finite numbers or with a sentence; not with exit status 0 and a number that is not
/// finite, not by a signal, and not beyond its limits.
///
/// Each seed gives one scene: `--only 17` runs it and prints its command line, `--only 0-499` runs
/// a range of seeds.
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/paths.h"
#include "base/random.h"
#include "lab/bench/bench.h"
#include "lab/run/bounded_run.h"
#include "lab/run/overrides.h"
#include "scene/key.h"

enum { SCENES = 10000, SCENES_QUICK = 32, BATCH = 64, PARALLEL = 2, KEYS_MAX = 3 };

static const double seconds = 0.3; ///< simulated [s]
static const double cpu_max = 2;   ///< of a run [s]

/// Keys that are not drawn: they do not affect the motion, or, like `seconds`, are set for each
/// run.
static const char* const left_out[] = {"seconds", "camera", "about", "because",
                                       "fails",   "show",   "units", "precision"};

/// The values of a scene that may be drawn: counts them, and draws the one with number `index`.
typedef struct Draw {
    Random* random;
    Overrides* sets;
    int index, count;
} Draw;

static int draw_below(Random* random, int count) {
    return (int)(random_next(random) * count);
}

static double draw_between(Random* random, double low, double high) {
    return low + random_next(random) * (high - low);
}

/// A random number of a range: one of its ends, uniform between them, or of random magnitude.
static double draw_number(Random* random, const Parameter* range) {
    const double kind = random_next(random), magnitude = random_next(random);
    const bool bounded = isfinite(range->min) && isfinite(range->max);
    if (kind < 0.1)
        return isfinite(range->min) ? range->min : -FLT_MAX;
    if (kind < 0.2)
        return isfinite(range->max) ? range->max : kind < 0.15 ? 0 : FLT_MAX;
    if (bounded && kind < 0.6)
        return draw_between(random, range->min, range->max);
    const double tens = kind < 0.4 ? 60 * magnitude - 30 : 12 * magnitude - 6;
    if (bounded)
        return range->min + (range->max - range->min) * pow(10, -fabs(tens));
    const double sign = range->min < 0 && random_next(random) < 0.5 ? -1 : 1;
    return sign * pow(10, tens);
}

static void draw_value(Random* random, const Key* key, char* text, size_t size) {
    const char* const* row;
    switch (key->type) {
        case KEY_NUMBER:
        case KEY_OPTIONAL:
            snprintf(text, size, "%.9g", draw_number(random, &key->is));
            break;
        case KEY_VECTOR:
            snprintf(text, size, "[%.6g, %.6g, %.6g]", draw_number(random, &key->is),
                     draw_number(random, &key->is), draw_number(random, &key->is));
            break;
        case KEY_NAME:
            snprintf(text, size, "%s", key->name[draw_below(random, key->name_count)]);
            break;
        case KEY_FLAG:
            snprintf(text, size, "%s", random_next(random) < 0.5 ? "true" : "false");
            break;
        default: // the name of a row of a table
            row = ((const char* const* const*)key->table)[draw_below(random, *key->table_count)];
            snprintf(text, size, "%s", *row);
    }
}

static bool can_be_drawn(const KeyValue* value) {
    const Key* key = value->key;
    for (size_t k = 0; k < sizeof left_out / sizeof *left_out; k++)
        if (strncmp(value->path, left_out[k], strlen(left_out[k])) == 0)
            return false;
    return key->type <= KEY_FLAG || (key->type == KEY_TEXT && key->table);
}

static void visit(const KeyValue* value, void* context) {
    Draw* draw = context;
    if (!can_be_drawn(value) || draw->count++ != draw->index)
        return;
    char text[128];
    draw_value(draw->random, value->key, text, sizeof text);
    overrides_add(draw->sets, "%s=%s", value->path, text);
}

/// Draw a scene and one to three of its values.
static bool draw_scene(uint64_t seed, char* const* path, int count, char scene[256],
                       Overrides* sets, Fault* fault) {
    Random random = {seed};
    random_next(&random); // neighboring seeds differ from here
    scene_name(path[draw_below(&random, count)], scene);
    WorldDef def;
    if (!scene_load(scene, NULL, 0, &def, fault))
        return false;
    Draw all = {.random = &random, .sets = sets, .index = -1};
    key_each_value(&def, visit, &all);
    for (int keys = 1 + draw_below(&random, KEYS_MAX); keys > 0; keys--) {
        Draw one = {.random = &random, .sets = sets, .index = draw_below(&random, all.count)};
        key_each_value(&def, visit, &one);
    }
    scene_free(&def);
    return true;
}

/// The range of seeds that are run, and the numbers of their endings.
typedef struct Part {
    char program[2][512]; ///< float, double
    char** path;          ///< [path_count] shipped scenes
    int path_count;
    uint64_t seed, end; ///< the next, and the one after the last
    bool says_all;
    int ending[ENDINGS];
} Part;

static bool add_run(const Part* part, Launch* launch, uint64_t seed, Fault* fault) {
    char scene[256];
    Overrides sets = {.count = 0};
    if (!draw_scene(seed, part->path, part->path_count, scene, &sets, fault))
        return false;
    bounded_run(launch, part->program[seed % 2], scene, seconds, 1, cpu_max);
    for (int k = 0; k < sets.count; k++)
        launch_add(launch, "--set=%s", sets.text[k]);
    return true;
}

static void judge(Part* part, uint64_t seed, const Launch* launch) {
    Report report;
    char text[ENDING_TEXT];
    report_read(&report, launch);
    const Ending ending = bounded_run_ending(launch, &report, text);
    part->ending[ending]++;
    if (part->says_all || ending >= ENDING_LONG) {
        printf("%llu %s: %s\n  ", (unsigned long long)seed, ending_name[ending], text);
        bounded_run_print(launch, stdout);
        puts("");
        fflush(stdout);
    }
    report_free(&report);
}

static bool run_batch(Part* part, Fault* fault) {
    Launch launch[BATCH];
    const uint64_t first = part->seed;
    int count = 0;
    bool good = true;
    for (; good && count < BATCH && part->seed < part->end; count++, part->seed++) {
        launch[count] = (Launch){.words = 0};
        good = add_run(part, &launch[count], part->seed, fault);
    }
    good = good && launch_all(launch, count, PARALLEL, "scenes", fault);
    for (int k = 0; k < count; k++) {
        if (good)
            judge(part, first + (uint64_t)k, &launch[k]);
        launch_free(&launch[k]);
    }
    return good;
}

/// Read the seeds A-B, or one seed, from a word.
static bool read_seeds(const char* word, bool quick, Part* part, Fault* fault) {
    unsigned long long first = 0, last = (quick ? SCENES_QUICK : SCENES) - 1;
    char rest;
    const int read = word ? sscanf(word, "%llu-%llu%c", &first, &last, &rest) : 2;
    if (read == 1)
        last = first;
    if (read != 1 && (read != 2 || last < first))
        return fault_set(fault, "--only", "'%s' is not a seed such as 17, or seeds such as 0-499",
                         word);
    part->seed = first;
    part->end = last + 1;
    part->says_all = read == 1;
    return true;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    Part part = {0};
    if (!read_seeds(options->only, options->quick, &part, fault) ||
        !paths_sibling("balloon", part.program[0], fault) ||
        !paths_sibling("balloon-double", part.program[1], fault))
        return false;
    const int count = (int)(part.end - part.seed);
    part.path_count = scene_list(&part.path);
    bool good = true;
    while (good && part.seed < part.end)
        good = run_batch(&part, fault);
    for (int k = 0; k < part.path_count; k++)
        free(part.path[k]);
    free(part.path);
    printf("%d scenes:", count);
    for (int e = 0; e < ENDINGS; e++)
        printf(" %d %s%s", part.ending[e], ending_name[e], e + 1 < ENDINGS ? "," : "\n");
    return good && (part.ending[ENDING_WRONG] == 0 ||
                    fault_set(fault, "bench scenes", "%d of %d scenes ended wrongly",
                              part.ending[ENDING_WRONG], count));
}

const BenchCase bench_scenes = {
    .name = "scenes",
    .about = "scenes with values drawn at random: each ends with numbers or a sentence",
    .run = measure,
};
