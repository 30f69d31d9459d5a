#include "lab/advice/needs.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "base/array.h"
#include "base/paths.h"
#include "base/table.h"
#include "lab/advice/needs_part.h"
#include "lab/run/report.h"
#include "lab/run/result_file.h"
#include "world/world.h"

enum { ROUNDS = 3, MAX_OUTPUTS = 16 };

/// UNTRIED: the guard split the longer step into the scene's own, so that nothing was simplified.
typedef enum Verdict { UNNEEDED, NEEDED, UNTRIED } Verdict;

/// A run of the scene, complete or without one part.
typedef struct Need {
    NeedsPart part; ///< the missing part; empty for the complete scene
    Launch launch;
    double value[MAX_OUTPUTS];  ///< NAN: this run lacks it
    double change[MAX_OUTPUTS]; ///< [tolerances]
    double ms;                  ///< CPU time per simulated second, minimum over the rounds [ms]
    int substeps;               ///< largest number into which the guard divided a step
    bool ended;                 ///< the run reached its end
    Verdict verdict;
    const char* because; ///< the scene's reason to keep the part; NULL: none
} Need;

typedef struct Needs {
    const NeedsOptions* options;
    World world; ///< the scene, before its first step
    Need* need;  ///< [count] the first is the complete scene
    int count;
    int capacity;
    unsigned outputs;
} Needs;

// --- the runs ------------------------------------------------------------------------------------

static double seconds_of(const WorldDef* def) {
    double last = 0;
    for (unsigned k = 0; k < scene_outputs(def); k++)
        last = fmax(last, def->about[k].at);
    return last;
}

static bool command(const Needs* needs, const Overrides* sets, Launch* launch, Fault* fault) {
    char program[512];
    if (!paths_sibling(sizeof(real) == sizeof(double) ? "balloon-double" : "balloon", program,
                       fault))
        return false;
    launch_add(launch, "%s", program);
    launch_add(launch, "run");
    launch_add(launch, "%s", needs->world.def.file);
    for (int k = 0; k < needs->options->set_count; k++)
        launch_add(launch, "--set=%s", needs->options->set[k].text);
    for (int k = 0; k < sets->count; k++)
        launch_add(launch, "--set=%s", sets->text[k]);
    launch_add(launch, "--seconds=%.17g", seconds_of(&needs->world.def));
    launch_add(launch, "--report");
    return true;
}

static bool add_need(Needs* needs, const NeedsPart* part, Fault* fault) {
    Overrides sets = {.count = 0};
    if (part)
        needs_part_simplify(part, &needs->world, &sets);
    if (part && sets.count == 0)
        return true;
    array_reserve(needs->need, needs->count, needs->capacity);
    Need* need = &needs->need[needs->count++];
    *need = (Need){.ms = INFINITY};
    if (part)
        need->part = *part;
    for (unsigned k = 0; part && k < needs->world.def.because_count; k++)
        if (strcmp(needs->world.def.because[k].part, part->name) == 0)
            need->because = needs->world.def.because[k].reason;
    return command(needs, &sets, &need->launch, fault);
}

static void read_results(Needs* needs, Need* need) {
    Report report;
    report_read(&report, &need->launch);
    for (unsigned k = 0; k < needs->outputs; k++)
        need->value[k] = report_output(&report, k);
    need->ended = report.ended;
    need->substeps = report.substeps;
    need->ms = fmin(need->ms, report.ms);
    report_free(&report);
}

static bool run_all(Needs* needs, Fault* fault) {
    Launch* launch = new_array(Launch, needs->count);
    bool good = true;
    for (int round = 0; good && round < (needs->options->quick ? 1 : ROUNDS); round++) {
        for (int k = 0; k < needs->count; k++)
            launch[k] = needs->need[k].launch;
        good = launch_all(launch, needs->count, needs->options->quick ? 2 : 1, "parts", fault);
        for (int k = 0; k < needs->count; k++) {
            needs->need[k].launch = launch[k];
            if (good)
                read_results(needs, &needs->need[k]);
        }
    }
    free(launch);
    return good;
}

// --- the verdict ---------------------------------------------------------------------------------

/// Whether the part was simplified: a doubled step was not if the guard made twice as many
/// substeps.
static bool is_simpler(const Need* need, const Need* complete) {
    return strcmp(need->part.name, "step") != 0 || need->substeps < 2 * complete->substeps;
}

/// The verdict follows from the changes; a part whose run did not reach its end is needed.
static void judge(Needs* needs) {
    const Need* complete = &needs->need[0];
    for (int n = 1; n < needs->count; n++) {
        Need* need = &needs->need[n];
        need->verdict = need->ended ? UNNEEDED : NEEDED;
        for (unsigned k = 0; k < needs->outputs; k++) {
            const double size = needs->world.def.about[k].tolerance * fabs(complete->value[k]);
            need->change[k] = fabs(need->value[k] - complete->value[k]) / size;
            if (!(need->change[k] < 1))
                need->verdict = NEEDED;
        }
        if (need->ended && !is_simpler(need, complete))
            need->verdict = UNTRIED;
    }
}

static bool can_be_judged(const Needs* needs, Fault* fault) {
    const WorldDef* def = &needs->world.def;
    if (def->about_count > 0 && def->about[0].none)
        return fault_set(fault, def->file, "it is about none: %s", def->about[0].none);
    if (def->about_count == 0)
        return fault_set(fault, def->file,
                         "it does not say what it is about, as in about: "
                         "[{output: balloon0.volume, at: 5, tolerance: 0.02}]");
    if (def->about_count > MAX_OUTPUTS)
        return fault_set(fault, def->file, "it is about more than %d outputs", MAX_OUTPUTS);
    for (unsigned k = 0; k < def->because_count; k++)
        if (!needs_part_exists(def->because[k].part))
            return fault_set(fault, def->file, "because: there is no part '%s'",
                             def->because[k].part);
    return true;
}

/// The run of the complete scene has all outputs, and none is 0, which has no relative tolerance.
static bool has_outputs(const Needs* needs, Fault* fault) {
    const Need* complete = &needs->need[0];
    if (!complete->ended)
        return fault_set(fault, needs->world.def.file, "it does not come to its end: %s",
                         complete->launch.err);
    for (unsigned k = 0; k < needs->outputs; k++)
        if (!(fabs(complete->value[k]) > 0))
            return fault_set(fault, needs->world.def.file,
                             "about: %s is no number that has a tolerance",
                             needs->world.def.about[k].output);
    return true;
}

// --- the table -----------------------------------------------------------------------------------

static const char* verdict_of(const Need* need) {
    return need->verdict == UNTRIED  ? "untried: the guard splits it to the scene's own"
           : need->verdict == NEEDED ? "needed"
           : need->because           ? "unneeded, but"
                                     : "UNNEEDED";
}

static void print_need(const Needs* needs, const Need* need) {
    printf("%-22s %-32s", need->part.name, need->part.instead);
    for (unsigned k = 0; k < needs->outputs; k++)
        if (need->ended && need->verdict != UNTRIED && isfinite(need->change[k]))
            printf(" %10.3g", need->change[k]);
        else
            printf(" %10s", "-");
    const double share = 100 * need->ms / needs->need[0].ms;
    if (isfinite(share))
        printf(" %8.0f %%  %s", share, verdict_of(need));
    else // too short for the clock
        printf(" %8s %%  %s", "-", verdict_of(need));
    if (need->verdict == UNNEEDED && need->because)
        printf(" %s", need->because);
    putchar('\n');
}

static void print_table(const Needs* needs) {
    const WorldDef* def = &needs->world.def;
    char name[256];
    scene_name(def->file, name);
    printf("%s\n", name);
    for (unsigned k = 0; k < needs->outputs; k++)
        printf("  %c: %s at %g s is %.6g, within %g %%\n", 'a' + (int)k, def->about[k].output,
               def->about[k].at, needs->need[0].value[k], 100 * def->about[k].tolerance);
    printf("%-22s %-32s", "part", "instead");
    for (unsigned k = 0; k < needs->outputs; k++)
        printf(" %10c", 'a' + (int)k);
    printf(" %10s\n", "CPU time");
    for (int n = 1; n < needs->count; n++)
        print_need(needs, &needs->need[n]);
}

/// The output with the largest change.
static unsigned most_changed(const Needs* needs, const Need* need) {
    unsigned max = 0;
    for (unsigned k = 0; k < needs->outputs; k++)
        if (!(need->change[k] <= need->change[max]))
            max = k;
    return max;
}

static void write_rows(const Needs* needs, FILE* out) {
    char name[256];
    scene_name(needs->world.def.file, name);
    for (int n = 1; n < needs->count; n++) {
        const Need* need = &needs->need[n];
        const unsigned k = most_changed(needs, need);
        const double tolerance = needs->world.def.about[k].tolerance;
        static const char* const needed[] = {"0", "1", ""};
        fprintf(out, "%s,%s,%.6g,%g,%.3g,%s,\"%s\"\n", name, need->part.name,
                need->change[k] * tolerance, tolerance, need->ms / needs->need[0].ms,
                needed[need->verdict], need->because ? need->because : "");
    }
}

/// Append the names of the unneeded parts that the scene gives no reason for.
static void name_unneeded(const Needs* needs, char* names, size_t size) {
    for (int n = 1; n < needs->count; n++) {
        const Need* need = &needs->need[n];
        if (need->verdict == UNNEEDED && !need->because)
            table_add_name(names, size, need->part.name);
    }
}

// --- one scene, or all ---------------------------------------------------------------------------

static bool open_needs(Needs* needs, const char* scene, const NeedsOptions* options, Fault* fault) {
    WorldDef def;
    *needs = (Needs){.options = options};
    if (!scene_load(scene, options->set, options->set_count, &def, fault) ||
        !world_open(&needs->world, &def, fault))
        return false;
    scene_say_renamed(&needs->world.def);
    needs->outputs = scene_outputs(&needs->world.def);
    bool good = can_be_judged(needs, fault) && add_need(needs, NULL, fault);
    NeedsPart part;
    for (int k = 0; good && needs_part_at(k, &part); k++)
        good = add_need(needs, &part, fault);
    return good;
}

static void close_needs(Needs* needs) {
    for (int k = 0; k < needs->count; k++)
        launch_free(&needs->need[k].launch);
    free(needs->need);
    world_close(&needs->world);
}

static bool one_scene(const char* scene, const NeedsOptions* options, FILE* csv, char* unneeded,
                      size_t size, Fault* fault) {
    Needs needs;
    const bool good = open_needs(&needs, scene, options, fault) && run_all(&needs, fault) &&
                      has_outputs(&needs, fault);
    if (good) {
        judge(&needs);
        print_table(&needs);
        fflush(stdout);
        if (csv)
            write_rows(&needs, csv);
        name_unneeded(&needs, unneeded, size);
    }
    close_needs(&needs);
    return good;
}

/// Whether the scene names outputs: 1, 0, or -1 with a fault if it does not load.
static int names_outputs(const char* path, Fault* fault) {
    WorldDef def;
    if (!scene_load(path, NULL, 0, &def, fault))
        return -1;
    const int some = scene_outputs(&def) > 0;
    scene_free(&def);
    return some;
}

static bool all_scenes(const NeedsOptions* options, FILE* csv, Fault* fault) {
    char** path;
    char all[sizeof fault->text] = "";
    const int count = scene_list(&path);
    bool good = true;
    for (int k = 0; k < count; k++) {
        char name[256], unneeded[512] = "";
        scene_name(path[k], name);
        const int some = good ? names_outputs(path[k], fault) : 0;
        good = good && some >= 0 &&
               (!some || one_scene(path[k], options, csv, unneeded, sizeof unneeded, fault));
        const size_t used = strlen(all);
        if (unneeded[0])
            snprintf(all + used, sizeof all - used, "%s%s: %s", used ? "; " : "", name, unneeded);
        free(path[k]);
    }
    free(path);
    return good && (!all[0] || fault_set(fault, NULL, "unneeded without a reason: %s", all));
}

static FILE* open_csv(const char* folder, Fault* fault) {
    static const char head[] = "scene,part,change,tolerance,cost_share,needed,because\n";
    FILE* csv =
        result_folder(folder, fault) ? result_file_open(folder, "needs.csv", head, fault) : NULL;
    if (csv)
        fputs(head, csv);
    return csv;
}

bool needs_run(const NeedsOptions* options, Fault* fault) {
    FILE* csv = options->out ? open_csv(options->out, fault) : NULL;
    char unneeded[512] = "";
    bool good = csv || !options->out;
    if (good && !options->scene)
        good = all_scenes(options, csv, fault);
    else if (good)
        good = one_scene(options->scene, options, csv, unneeded, sizeof unneeded, fault);
    good = (!csv || result_file_close(csv, options->out, "needs.csv", fault)) && good;
    if (good && unneeded[0])
        return fault_set(fault, options->scene, "unneeded without a reason: %s", unneeded);
    return good;
}

void needs_list(void) {
    char** path;
    const int count = scene_list(&path);
    for (int k = 0; k < count; k++) {
        WorldDef def;
        Fault bad = {0};
        char name[256];
        scene_name(path[k], name);
        if (scene_load(path[k], NULL, 0, &def, &bad)) {
            if (def.about_count == 0)
                printf("%-26s -\n", name);
            for (unsigned n = 0; n < def.about_count; n++)
                if (def.about[n].none)
                    printf("%-26s none: %s\n", name, def.about[n].none);
                else
                    printf("%-26s %s at %g s, within %g %%\n", n ? "" : name, def.about[n].output,
                           def.about[n].at, 100 * def.about[n].tolerance);
            scene_free(&def);
        } else {
            printf("%-26s %s\n", name, bad.text);
        }
        free(path[k]);
    }
    free(path);
}
