#include "cli/open.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

#include "base/paths.h"
#include "show/pacer.h"

static const double AUTO_BUDGET = 8; ///< half a frame of 1/60 s; drawing needs the other half [ms]

char** cli_arguments;

bool cli_other_precision(const char* program, Fault* fault) {
    char path[512];
    if (!paths_sibling(program, path, fault))
        return false;
    execv(path, cli_arguments);
    return fault_set(fault, path, "cannot be started: %s", strerror(errno));
}

bool cli_open_advice(const Options* options, AdviseOptions* advise, Fault* fault) {
    const char* own = sizeof(real) == sizeof(double) ? "double" : "float";
    *advise = (AdviseOptions){.scene = options->target ? options->target : "party",
                              .set = options->set,
                              .set_count = options->set_count,
                              .fresh = options->fresh,
                              .out = options->out,
                              .report = options->report,
                              .precision = options->report ? own : NULL};
    if (!options_quantity(options->error, "--error", "%", 0.01, &advise->error, fault) ||
        !options_quantity(options->budget, "--budget", "ms", 1, &advise->ms, fault))
        return false;
    if (options->advised && advise->error == 0 && advise->ms == 0)
        advise->ms = AUTO_BUDGET;
    return true;
}

static bool opens(const char* name, const SceneSet* set, int set_count) {
    WorldDef def;
    World world;
    Fault unused = {0};
    if (!scene_load(name, set, set_count, &def, &unused) || !world_open(&world, &def, &unused))
        return false;
    world_close(&world);
    return true;
}

static bool all_sets(const Options* options, const char* method, Sets* sets, Fault* fault) {
    sets->count = options->set_count;
    sets->advised.count = 0;
    memcpy(sets->set, options->set, sizeof options->set);
    if (options->advised) {
        AdviseOptions advise;
        if (!cli_open_advice(options, &advise, fault))
            return false;
        // where nothing can be advised, the scene as it is is the best so far
        Fault none = {0};
        if (!advise_auto(&advise, &sets->advised, &none) &&
            opens(advise.scene, options->set, options->set_count))
            fprintf(stderr, "balloon: no advice: %s\n", none.text);
    }
    for (int k = 0; k < sets->advised.count; k++)
        sets->set[sets->count++].text = sets->advised.text[k];
    if (method) {
        snprintf(sets->method, sizeof sets->method, "method=%s", method);
        sets->set[sets->count++].text = sets->method;
    }
    return true;
}

/// A fault in an override that an option stands for names that: `--method M` instead of `--set
/// method=M`, and `--compare M` where this is the second copy's method.
static void name_option(const Options* options, const char* method, Fault* fault) {
    static const char start[] = "--set ";
    const char* text = fault->location + strlen(start);
    const char* value = strchr(fault->location, '=');
    if (strncmp(fault->location, start, strlen(start)) != 0 || !value)
        return;
    const char* name = NULL;
    for (int k = 0; k < options->set_count && !name; k++)
        if (strcmp(text, options->typed[k]) == 0)
            name = options_short_for(text, (size_t)(value - text));
    if (method && strncmp(text, "method=", strlen("method=")) == 0 &&
        strcmp(value + 1, method) == 0)
        name = "--compare";
    if (!name)
        return;
    char location[sizeof fault->location];
    snprintf(location, sizeof location, "%s %s", name, value + 1);
    memcpy(fault->location, location, sizeof location);
}

/// Load the scene and open its world in the precision that it names. method: replaces the scene's;
/// NULL: does not.
static bool open_copy(const Options* options, const char* method, Sets* sets, World* world,
                      Fault* fault) {
    WorldDef def;
    const char* target = options->target ? options->target : "party";
    if (!all_sets(options, method, sets, fault) ||
        !scene_load(target, sets->set, sets->count, &def, fault)) {
        name_option(options, method, fault);
        return false;
    }
    if (!options->quiet && !method)
        scene_say_renamed(&def);

    const bool is_double = sizeof(real) == sizeof(double);
    if (def.precision != PRECISION_ANY && (def.precision == PRECISION_DOUBLE) != is_double) {
        scene_free(&def);
        return cli_other_precision(is_double ? "balloon" : "balloon-double", fault);
    }
    const bool good = world_open(world, &def, fault);
    if (!good && sets->count > 0)
        scene_blame(target, sets->set, sets->count, opens, fault);
    if (!good)
        name_option(options, method, fault);
    return good;
}

bool cli_open_world(const Options* options, World* world, Fault* fault) {
    Sets sets;
    return open_copy(options, NULL, &sets, world, fault);
}

bool cli_open_pair(const Options* options, Sets* sets, World* world, Ghost* ghost, Fault* fault) {
    Sets other;
    if (!open_copy(options, NULL, sets, world, fault))
        return false;
    if (!options->compare || open_copy(options, options->compare, &other, &ghost->world, fault))
        return true;
    world_close(world);
    return false;
}

bool cli_times(const Options* options, const World* world, double* seconds, double* fps,
               Fault* fault) {
    if (!options_number(options->seconds, "--seconds", world->def.seconds, seconds, fault) ||
        !options_number(options->fps, "--fps", 60, fps, fault))
        return false;
    if (!(*seconds / world->step < PACER_STEPS_MAX))
        return fault_set(fault, options->seconds ? "--seconds" : world->def.file,
                         "%g s are more steps of %g s than can be counted", *seconds, world->step);
    return *seconds * *fps < PACER_STEPS_MAX ||
           fault_set(fault, options->fps ? "--fps" : "--seconds",
                     "%g s at %g frames per second are more than can be counted", *seconds, *fps);
}
