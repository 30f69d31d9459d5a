/// Reads the command line, calls one verb, prints the one fault.
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/crew.h"
#include "force/force.h"
#include "lab/advise.h"
#include "lab/bench.h"
#include "lab/chart.h"
#include "lab/needs.h"
#include "lab/peer_run.h"
#include "lab/stability.h"
#include "mesh/load.h"
#include "mesh/shape.h"
#include "show/show.h"
#include "show/keys.h"
#include "show/run.h"
#include "view/mode.h"
#include "world/fails.h"
#include "world/place.h"
#include "world/world.h"

#define VERSION "0.1.0"
enum { SETS_MOST = 64, EXIT_USAGE = 2 };
static const double auto_budget = 8; ///< half a frame, the other half draws [ms]

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
    const char* obj;
    const char* mode;
    const char* fit;
    const char* threads;
    const char* compare;
    const char* error;
    const char* budget;
    bool hash, time, quiet, overlay, lab, keep, quick, all, fresh, advised;
    SceneSet set[SETS_MOST];
    int set_count;
    char typed[SETS_MOST][256]; ///< texts of the sets that options such as --step stand for
} Options;

/// One option: it fills a text or a flag, or stands for `--set key=VALUE`.
typedef struct Option {
    const char* name;
    const char* value; ///< what its value is called, NULL for a flag
    const char* about;
    size_t text;     ///< offset of a const char* in Options
    size_t flag;     ///< offset of a bool in Options
    const char* key; ///< the scene's key that it sets
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
    {"--lab",       NULL,       "play, render: pictures with the lab's page",     FLAG(lab)},
    {"--input",     "FILE",     "replay an input log",                             TEXT(input)},
    {"--record",    "FILE",     "write the session's input log",                   TEXT(record)},
    {"--csv",       "FILE",     "numbers, one row a frame; - for standard output", TEXT(csv)},
    {"--obj",       "FILE",     "the skins at the end",                            TEXT(obj)},
    {"--hash",      NULL,       "print the hash of the state at the end",          FLAG(hash)},
    {"--time",      NULL,       "print the CPU time of stepping, or of a frame's stages",           FLAG(time)},
    {"--quiet",     NULL,       "say nothing but results and faults",              FLAG(quiet)},
    {"--threads",   "N",        "threads that share a step, same bits; 1",         TEXT(threads)},
    {"--keep",      NULL,       "bench: keep these figures, to compare later ones with", FLAG(keep)},
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

typedef struct Verb {
    const char* name;
    const char* target; ///< what it wants, NULL for nothing
    const char* about;
    bool (*call)(const Options* options, Fault* fault);
} Verb;
// clang-format on

static bool number(const char* text, const char* option, double given, double* value,
                   Fault* fault) {
    char* end;
    *value = text ? strtod(text, &end) : given;
    if (text && (end == text || *end || !isfinite(*value) || *value <= 0))
        return fault_set(fault, option, "'%s' is not a number above 0", text);
    return true;
}

/// The other precision is another program; it reads the same command line again.
static bool hand_over(const char* program, char** argv, Fault* fault) {
    char path[512];
    if (!place_sibling(program, path, fault))
        return false;
    execv(path, argv);
    return fault_set(fault, path, "cannot be started: %s", strerror(errno));
}

/// "1%", "0.01" or "4ms": a number and its unit.
static bool quantity(const char* text, const char* option, const char* unit, double of_unit,
                     double* value, Fault* fault) {
    char* end;
    *value = text ? strtod(text, &end) : 0;
    const bool has_unit = text && end > text && strcmp(end, unit) == 0;
    if (text && (end == text || (*end && !has_unit) || !isfinite(*value) || *value <= 0))
        return fault_set(fault, option, "'%s' is not a number above 0, as in 4%s", text, unit);
    *value *= has_unit ? of_unit : 1;
    return true;
}

static bool advise_options(const Options* options, AdviseOptions* advise, Fault* fault) {
    *advise = (AdviseOptions){.scene = options->target ? options->target : "party",
                              .set = options->set,
                              .set_count = options->set_count,
                              .fresh = options->fresh,
                              .out = options->out};
    return quantity(options->error, "--error", "%", 0.01, &advise->error, fault) &&
           quantity(options->budget, "--budget", "ms", 1, &advise->ms, fault);
}

/// The scene's overrides, with those of advice and one more where there is one.
typedef struct Sets {
    SceneSet set[SETS_MOST + OVERRIDES_MOST + 1];
    int count;
    Overrides advised;
    char method[80];
} Sets;

static bool all_sets(const Options* options, const char* method, Sets* sets, Fault* fault) {
    sets->count = options->set_count;
    sets->advised.count = 0;
    memcpy(sets->set, options->set, sizeof options->set);
    if (options->advised) {
        AdviseOptions advise;
        if (!advise_options(options, &advise, fault))
            return false;
        if (advise.error == 0 && advise.ms == 0)
            advise.ms = auto_budget;
        if (!advise_auto(&advise, &sets->advised, fault))
            return false;
    }
    for (int k = 0; k < sets->advised.count; k++)
        sets->set[sets->count++].text = sets->advised.text[k];
    if (method) {
        snprintf(sets->method, sizeof sets->method, "method=%s", method);
        sets->set[sets->count++].text = sets->method;
    }
    return true;
}

/// Read the scene and open its world, in the precision that it asks for; with a method of its own,
/// or as it is.
static bool open_copy(const Options* options, const char* method, Sets* sets, World* world,
                      char** argv, Fault* fault) {
    WorldDef def;
    const char* target = options->target ? options->target : "party";
    if (!all_sets(options, method, sets, fault) ||
        !scene_load(target, sets->set, sets->count, &def, fault))
        return false;

    const bool is_double = sizeof(real) == sizeof(double);
    if (def.precision != PRECISION_ANY && (def.precision == PRECISION_DOUBLE) != is_double) {
        scene_free(&def);
        return hand_over(is_double ? "balloon" : "balloon-double", argv, fault);
    }
    return world_open(world, &def, fault);
}

static bool open_world(const Options* options, World* world, char** argv, Fault* fault) {
    Sets sets;
    return open_copy(options, NULL, &sets, world, argv, fault);
}

static char** arguments; ///< as main got them, for a hand-over to the other precision

/// The world, and with --compare its ghost; both are closed by the caller. sets: the world's.
static bool open_pair(const Options* options, Sets* sets, World* world, Ghost* ghost,
                      Fault* fault) {
    Sets other;
    if (!open_copy(options, NULL, sets, world, arguments, fault))
        return false;
    if (!options->compare ||
        open_copy(options, options->compare, &other, &ghost->world, arguments, fault))
        return true;
    world_close(world);
    return false;
}

static bool show_options(const Options* options, const Sets* sets, const World* world, Ghost* ghost,
                         ShowOptions* show, Fault* fault) {
    *show = show_options_default();
    show->out = options->out ? options->out : "out";
    show->input = options->input;
    show->record = options->record;
    show->mode = options->mode;
    show->set = sets->set;
    show->set_count = sets->count;
    show->quiet = options->quiet;
    show->time = options->time;
    show->overlay = options->overlay;
    show->compare = options->compare;
    show->ghost = options->compare ? ghost : NULL;
    show->lab = options->lab;
    if (options->size &&
        (sscanf(options->size, "%dx%d", &show->width, &show->height) != 2 || show->width < 16 ||
         show->height < 16 || show->width > 16384 || show->height > 16384))
        return fault_set(fault, "--size", "'%s' is not a size such as 1280x720", options->size);
    const double given = world->def.seconds > 0 ? world->def.seconds : 10;
    return number(options->seconds, "--seconds", given, &show->seconds, fault) &&
           number(options->fps, "--fps", 60, &show->fps, fault);
}

static void print_hash(const World* world) {
    printf("%016llx\n", (unsigned long long)world_hash(world));
}

static bool verb_play(const Options* options, Fault* fault) {
    World world;
    ShowOptions show;
    Ghost ghost = {0};
    Sets sets;
    if (!open_pair(options, &sets, &world, &ghost, fault))
        return false;
    bool good = show_options(options, &sets, &world, &ghost, &show, fault);
    show.overlay = true;
    if (!options->seconds) // a window stays open
        show.seconds = 0;
    good = good && show_play(&world, &show, fault);
    if (good && options->hash)
        print_hash(&world);
    world_close(&world);
    world_close(&ghost.world);
    return good;
}

static bool verb_render(const Options* options, Fault* fault) {
    World world;
    ShowOptions show;
    Ghost ghost = {0};
    Sets sets;
    if (!open_pair(options, &sets, &world, &ghost, fault))
        return false;
    const bool good = show_options(options, &sets, &world, &ghost, &show, fault) &&
                      show_render(&world, &show, fault);
    if (good && options->hash)
        print_hash(&world);
    world_close(&world);
    world_close(&ghost.world);
    return good;
}

static bool verb_run(const Options* options, Fault* fault) {
    World world;
    Ghost ghost = {0};
    Sets sets;
    RunOptions run_options = {.csv = options->csv,
                              .obj = options->obj,
                              .input = options->input,
                              .record = options->record,
                              .time = options->time,
                              .ghost = options->compare ? &ghost : NULL,
                              .quiet = options->quiet};
    if (!open_pair(options, &sets, &world, &ghost, fault))
        return false;
    const double given = world.def.seconds > 0 ? world.def.seconds : 10;
    const bool good = number(options->seconds, "--seconds", given, &run_options.seconds, fault) &&
                      number(options->fps, "--fps", 60, &run_options.fps, fault) &&
                      run(&world, &run_options, fault);
    if (good && options->hash)
        print_hash(&world);
    world_close(&world);
    world_close(&ghost.world);
    return good;
}

static bool read_fit(const char* text, PeerFit* fit, Fault* fault) {
    char rest;
    if (text && sscanf(text, "%lf%c", &fit->spring, &rest) == 1 && fit->spring > 0)
        return true;
    fit->spring = 0;
    const int count =
        text ? sscanf(text, "%lf,%lf,%lf%c", &fit->pressure, &fit->ratio, &fit->step, &rest) : 2;
    return ((count == 2 || count == 3) && fit->pressure >= 0 && fit->ratio >= 0 &&
            fit->step >= 0) ||
           fault_set(fault, "--fit",
                     "'%s' is not a pressure and a volume such as 800,1.33, nor a stiffness", text);
}

static bool verb_peer(const Options* options, Fault* fault) {
    World world;
    PeerRun peer = {.time = options->time, .quiet = options->quiet};
    if (!options->target)
        return fault_set(fault, NULL, "Bullet in which scene? See balloon --help");
    if (options->csv && strcmp(options->csv, "-") != 0)
        return fault_set(fault, "--csv", "a peer prints its numbers; write --csv -");
    if (!read_fit(options->fit, &peer.fit, fault) || !open_world(options, &world, arguments, fault))
        return false;
    const double given = world.def.seconds > 0 ? world.def.seconds : 10;
    const bool good = number(options->seconds, "--seconds", given, &peer.seconds, fault) &&
                      number(options->fps, "--fps", 60, &peer.fps, fault) &&
                      peer_run(&world, &peer, options->csv ? stdout : NULL, fault);
    if (good && options->hash)
        print_hash(&world);
    world_close(&world);
    return good;
}

static bool verb_check(const Options* options, Fault* fault) {
    Mesh mesh = {0};
    MeshReport report = {0};
    char path[512];
    const WorldDef nowhere = {0};
    if (!options->target)
        return fault_set(fault, NULL, "check which mesh? See balloon --help");
    if (!scene_model_path(&nowhere, options->target, path, fault))
        return false;
    const bool good = mesh_load(path, &mesh, &report, fault);
    if (good || report.unusable.text[0])
        doctor_print(&report, stdout);
    if (!good)
        return false;

    const bool all[SPRING_KINDS] = {true, true, true};
    Springs springs = {0};
    springs_find(&mesh, all, &springs);
    for (int kind = 0; kind < SPRING_KINDS; kind++)
        printf("%s springs: %d\n", spring_kind_name[kind],
               springs.from[kind + 1] - springs.from[kind]);
    springs_free(&springs);
    mesh_free(&mesh);
    return true;
}

static bool verb_bench(const Options* options, Fault* fault) {
    const BenchCase* one = options->target ? bench_find(options->target) : NULL;
    if (options->target && !one)
        return fault_set(fault, options->target, "no such bench; see balloon list");
    const BenchOptions bench = {
        .quick = options->quick, .keep = options->keep, .out = options->out ? options->out : "out"};
    for (int k = 0; k < bench_count; k++)
        if ((!one || one == bench_table[k]) && !bench_table[k]->run(&bench, fault))
            return false;
    return true;
}

/// A push of 1e-6 needs a state of double.
static bool verb_stability(const Options* options, Fault* fault) {
    if (sizeof(real) != sizeof(double))
        return hand_over("balloon-double", arguments, fault);
    return stability(options->out ? options->out : "out", options->quick, fault);
}

static bool verb_chart(const Options* options, Fault* fault) {
    char program[2][512];
    if (!place_sibling("balloon", program[0], fault) ||
        !place_sibling("balloon-double", program[1], fault))
        return false;
    const ChartOptions chart = {.out = options->out ? options->out : "out",
                                .only = options->target,
                                .extent = options->all     ? CHART_ALL
                                          : options->quick ? CHART_QUICK
                                                           : CHART_FULL,
                                .program = {program[0], program[1]}};
    return chart_run(&chart, fault);
}

/// Without a scene: what each is about, or with --all what each needs.
static bool verb_needs(const Options* options, Fault* fault) {
    const NeedsOptions needs = {.scene = options->target,
                                .out = options->out,
                                .set = options->set,
                                .set_count = options->set_count,
                                .quick = options->quick};
    if (options->target || options->all)
        return needs_run(&needs, fault);
    needs_list();
    return true;
}

static bool verb_advise(const Options* options, Fault* fault) {
    AdviseOptions advise;
    if (!options->target)
        return fault_set(fault, NULL, "advise on which scene? See balloon --help");
    if (!options->error == !options->budget)
        return fault_set(fault, options->target,
                         "say what you ask for: --error 1%% or --budget 4ms");
    return advise_options(options, &advise, fault) && advise_run(&advise, fault);
}

/// A scene of failures is told from the others by how it fails.
static void list_scenes(char** path, int count, bool failures) {
    for (int k = 0; k < count; k++) {
        WorldDef def;
        Fault bad = {0};
        const bool good = scene_load(path[k], NULL, 0, &def, &bad);
        char name[256], words[512];
        scene_name(path[k], name);
        if (failures == (good && def.fails)) {
            printf("  %-22s %s\n", name, !good ? bad.text : def.title ? def.title : "");
            if (failures) {
                fails_words(def.fails, words, sizeof words);
                printf("  %-22s %s\n", "", words);
            }
        }
        if (good)
            scene_free(&def);
    }
}

static bool verb_list(const Options* options, Fault* fault) {
    (void)options;
    (void)fault;
    char** path;
    const int scenes = scene_list(&path);
    puts("scenes (assets/scenes)");
    list_scenes(path, scenes, false);
    puts("scenes that fail (assets/scenes/fails)");
    list_scenes(path, scenes, true);
    for (int k = 0; k < scenes; k++)
        free(path[k]);
    free(path);
    puts("models that the program makes itself");
    for (int k = 0; k < shape_count; k++)
        printf("  %-22s %s\n", shape_table[k].name, shape_table[k].about);
    puts("forces");
    for (int k = 0; k < force_count; k++)
        printf("  %-22s %s\n", force_table[k]->name, force_table[k]->about);
    puts("methods");
    for (int k = 0; k < method_count; k++)
        printf("  %-22s %s\n", method_table[k]->name, method_table[k]->about);
    puts("benches");
    for (int k = 0; k < bench_count; k++)
        printf("  %-22s %s\n", bench_table[k]->name, bench_table[k]->about);
    puts("charts");
    for (int k = 0; k < chart_count; k++)
        printf("  %s %-20s %s\n", chart_table[k]->letter, chart_table[k]->scene,
               chart_table[k]->about);
    puts("display modes");
    for (int k = 0; k < mode_count; k++)
        printf("  %-22s %s\n", mode_table[k]->name, mode_table[k]->about);
    return true;
}

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
};
enum { VERBS = sizeof verb_table / sizeof *verb_table };
// clang-format on

static void print_help(void) {
    puts("balloon: any quad mesh becomes a rubber balloon\n");
    for (int k = 0; k < VERBS; k++)
        printf("  balloon %-9s %-13s %s\n", verb_table[k].name, verb_table[k].target,
               verb_table[k].about);
    puts("\noptions");
    for (int k = 0; k < OPTIONS; k++)
        printf("  %-11s %-14s  %s\n", option_table[k].name,
               option_table[k].value ? option_table[k].value : "", option_table[k].about);
    puts("  --help, --version\n\nkeys");
    keys_print(stdout);
}

static bool take_option(Options* options, const Option* option, const char* value, Fault* fault) {
    if (option->key) {
        if (options->set_count == SETS_MOST)
            return fault_set(fault, option->name, "at most %d of these", SETS_MOST);
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

static const Option* find_option(const char* name, size_t length) {
    for (int k = 0; k < OPTIONS; k++)
        if (strlen(option_table[k].name) == length &&
            strncmp(option_table[k].name, name, length) == 0)
            return &option_table[k];
    return NULL;
}

/// Options in any place, "--key value" or "--key=value"; the words left are verb and target.
static bool read_arguments(int argc, char** argv, Options* options, const Verb** verb,
                           Fault* fault) {
    *verb = &verb_table[0];
    bool verb_said = false;
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
            if (!take_option(options, option, value, fault))
                return false;
            continue;
        }
        bool is_verb = false;
        for (int k = 0; !verb_said && !options->target && k < VERBS; k++)
            if (strcmp(verb_table[k].name, word) == 0) {
                *verb = &verb_table[k];
                is_verb = verb_said = true;
            }
        if (!is_verb && options->target)
            return fault_set(fault, word, "only one scene or mesh at a time");
        if (!is_verb)
            options->target = word;
    }
    return true;
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

    arguments = argv;
    Options options = {0};
    const Verb* verb;
    Fault fault = {0};
    if (!read_arguments(argc, argv, &options, &verb, &fault)) {
        fault_print(&fault, stderr);
        return EXIT_USAGE;
    }
    double threads;
    bool good = number(options.threads, "--threads", 1, &threads, &fault);
    if (good) {
        crew_set((int)fmin(threads, CREW_MOST));
        good = verb->call(&options, &fault);
        crew_set(1);
    }
    if (good)
        return EXIT_SUCCESS;
    fault_print(&fault, stderr);
    return EXIT_FAILURE;
}
