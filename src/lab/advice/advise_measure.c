#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "lab/advice/advise.h"
#include "lab/run/refinement.h"
#include "lab/run/report.h"
#include "base/paths.h"

enum { COARSEST = -3, FINEST = 2, HALVINGS = 12, RETIMES = 2 };

/// A mesh of more points is too slow for what it gains. [1]
static const int points_most = 12000, reference_points_most = 3000;
/// No frame that costs 25 ms is of use to a window. CPU time per simulated second [ms]
static const double cost_most = 1500;
/// Steps nearer to each other than this tell nothing of each other's errors. [1]
static const double told_apart = 0.9;
/// Of scenes a little off nothing is promised closer than this. [1]
static const double closest_promise = 1e-4;
/// What an error may be more than it seems where no neighbor tells. [1]
static const double unknown = 2;
/// Errors above this are not those of a float's rounding. [1]
static const double rounding_most = 2e-3;
/// An error that is within this factor of the best stands still: shorter steps gain nothing. What
/// falls between two steps of a moving scene may be worse for once. [1]
static const double progress = 0.8;
/// Shorter runs are lost in the clock and in cold caches. [s]
static const double seconds_least = 0.3;

/// One method on one level in one precision: its steps are measured one after the other.
typedef struct Line {
    const Method* method;
    const char* precision;
    int level;
    int halving; ///< of the step to be measured next
    int closest; ///< of the least error
    double best; ///< least error so far
    double cost; ///< the least, per simulated second [ms]
    bool done;
} Line;

typedef struct Study {
    const char* scene;
    const SceneSet* set;
    int set_count;
    World world; ///< the scene, before its first step
    unsigned outputs;
    Line* line;
    int lines;
    Advice* advice;
    double (*value)[ADVISE_OUTPUTS]; ///< [room] of each point
    double* part;                    ///< [room] its step as the guard had it made [s]
} Study;

static bool command(const Study* study, const char* method, const char* precision, int level,
                    double step, Launch* launch, Fault* fault) {
    char program[512];
    if (!paths_sibling("balloon", program, fault))
        return false;
    const WorldDef* def = &study->world.def;
    const AdvicePoint at = {.level = level, .step = step};
    AdvicePoint point = at;
    snprintf(point.method, sizeof point.method, "%s", method);
    snprintf(point.precision, sizeof point.precision, "%s", precision);
    Overrides sets = {.count = 0};
    advise_sets(&study->world, &point, &sets);
    double seconds = seconds_least;
    for (unsigned k = 0; k < study->outputs; k++)
        seconds = fmax(seconds, def->about[k].at);
    launch_add(launch, "%s", program);
    launch_add(launch, "run");
    launch_add(launch, "%s", study->scene);
    for (int k = 0; k < study->set_count; k++)
        launch_add(launch, "--set=%s", study->set[k].text);
    for (int k = 0; k < sets.count; k++)
        launch_add(launch, "--set=%s", sets.text[k]);
    launch_add(launch, "--seconds=%.17g", seconds);
    launch_add(launch, "--report");
    return true;
}

static bool run_one(const Study* study, const char* method, const char* precision, int level,
                    double step, double value[], Report* report, Fault* fault) {
    Launch launch = {.words = 0};
    const bool good = command(study, method, precision, level, step, &launch, fault) &&
                      launch_all(&launch, 1, 1, "advice", fault);
    if (good) {
        report_read(report, &launch);
        for (unsigned k = 0; k < study->outputs; k++)
            value[k] = report_output(report, k);
    }
    launch_free(&launch);
    return good;
}

// --- the reference -------------------------------------------------------------------------------

static int points_at(const Study* study, int level) {
    Overrides sets = {.count = 0};
    if (level != 0 && !refinement_add(&study->world, level, &sets))
        return 0;
    SceneSet set[MAX_OVERRIDES * 2];
    int count = 0, points = 0;
    for (int k = 0; k < study->set_count; k++)
        set[count++] = study->set[k];
    for (int k = 0; k < sets.count; k++)
        set[count++].text = sets.text[k];
    WorldDef def;
    World world;
    Fault unused = {0};
    if (!scene_load(study->scene, set, count, &def, &unused) || !world_open(&world, &def, &unused))
        return 0;
    for (int b = 0; b < world.balloon_count; b++)
        points += world.balloon[b].body.count;
    world_close(&world);
    return points;
}

/// What the scene's method tells of no step on a level, 2 v(h/2) - v(h); how far v(h/2) is off too.
static bool endless_step(const Study* study, int level, double value[], Fault* fault) {
    Report report;
    const char* method = study->world.method->name;
    double step = fmin(study->world.step, 1 / ADVISE_FPS), coarse[ADVISE_OUTPUTS];
    if (!run_one(study, method, "double", level, step, coarse, &report, fault))
        return false;
    step /= 2 * exp2(ceil(log2(report.substeps)));
    report_free(&report);
    if (!run_one(study, method, "double", level, step, coarse, &report, fault))
        return false;
    report_free(&report);
    if (!run_one(study, method, "double", level, step / 2, value, &report, fault))
        return false;
    report_free(&report);
    for (unsigned k = 0; k < study->outputs; k++)
        value[k] = 2 * value[k] - coarse[k];
    return true;
}

static bool find_reference(Study* study, Fault* fault) {
    int fine = 0;
    while (fine < FINEST && points_at(study, fine + 1) > 0 &&
           points_at(study, fine + 1) <= reference_points_most)
        fine++;
    study->advice->floor = closest_promise;
    double finest[ADVISE_OUTPUTS], coarser[ADVISE_OUTPUTS];
    if (!endless_step(study, fine, finest, fault))
        return false;
    memcpy(coarser, finest, sizeof coarser);
    if (points_at(study, fine - 1) > 0 && !endless_step(study, fine - 1, coarser, fault))
        return false;
    for (unsigned k = 0; k < study->outputs; k++) {
        study->advice->reference[k] = finest[k] + (finest[k] - coarser[k]) / 3;
        if (!(fabs(study->advice->reference[k]) > 0))
            return fault_set(fault, study->world.def.file,
                             "about: %s has no value to compare with at %g s",
                             study->world.def.about[k].output, study->world.def.about[k].at);
        study->advice->floor =
            fmax(study->advice->floor, 0.1 * fabs(finest[k] - study->advice->reference[k]) /
                                           fabs(study->advice->reference[k]));
    }
    return true;
}

// --- the points ----------------------------------------------------------------------------------

static bool is_refused(const Study* study, const Method* method) {
    for (int b = 0; b < study->world.balloon_count; b++)
        if (method_refuses(method, &study->world.balloon[b].body))
            return true;
    return false;
}

static void add_lines(Study* study) {
    static const char* const precision[] = {"float", "double"};
    study->line = new_array(Line, (FINEST - COARSEST + 1) * method_count * 2);
    for (int level = COARSEST; level <= FINEST; level++) {
        const int points = points_at(study, level);
        for (int m = 0; points > 0 && points <= points_most && m < method_count; m++)
            for (int p = 0; p < 2; p++)
                if (!is_refused(study, method_table[m]))
                    study->line[study->lines++] = (Line){.method = method_table[m],
                                                         .precision = precision[p],
                                                         .level = level,
                                                         .best = INFINITY,
                                                         .cost = INFINITY};
    }
    const int room = study->lines * (HALVINGS + 1);
    study->advice->point = new_array(AdvicePoint, room);
    study->value = new_array(double[ADVISE_OUTPUTS], room);
    study->part = new_array(double, room);
}

static double error_of(const Study* study, const double value[]) {
    double most = 0;
    for (unsigned k = 0; k < study->outputs; k++) {
        const double error =
            fabs(value[k] - study->advice->reference[k]) / fabs(study->advice->reference[k]);
        most = error <= most ? most : isfinite(error) ? error : INFINITY;
    }
    return most;
}

/// Measure the line's next step, and say which comes after it.
static bool go_on(Study* study, Line* line, Fault* fault) {
    Report report;
    double* value = study->value[study->advice->count];
    const double step = 1 / ADVISE_FPS / exp2(line->halving);
    if (!run_one(study, line->method->name, line->precision, line->level, step, value, &report,
                 fault))
        return false;
    study->part[study->advice->count] = step / report.substeps;
    AdvicePoint* point = &study->advice->point[study->advice->count++];
    *point = (AdvicePoint){.level = line->level,
                           .step = step,
                           .error = report.ended ? error_of(study, value) : INFINITY,
                           .ms = report.ms / ADVISE_FPS};
    snprintf(point->method, sizeof point->method, "%s", line->method->name);
    snprintf(point->precision, sizeof point->precision, "%s", line->precision);

    line->cost = fmin(line->cost, report.ms);
    const bool idle = isfinite(point->error) && point->error >= progress * line->best &&
                      point->error * progress <= line->best;
    if (point->error < line->best) {
        line->best = point->error;
        line->closest = line->halving;
    }
    line->halving += report.substeps > 1 ? (int)ceil(log2(report.substeps)) : 1;
    line->done = line->halving > HALVINGS || idle ||
                 (report.ended && report.ms * (report.substeps > 1 ? 1 : 2) > cost_most);
    report_free(&report);
    return true;
}

/// The other's values as an error of the point's, whatever the reference.
static double apart(const Study* study, const double value[], const double other[]) {
    double most = 0;
    for (unsigned k = 0; k < study->outputs; k++)
        most = fmax(most, fabs(value[k] - other[k]) / fabs(study->advice->reference[k]));
    return most;
}

/// Of the points with the same method and precision: on the level above with the same step, or on
/// the same level with the nearest step on one side. NONE: there is none that came to its end.
static int neighbor(const Study* study, int k, int level, int side) {
    const AdvicePoint* point = study->advice->point;
    int best = NONE;
    for (int q = 0; q < study->advice->count; q++) {
        const double ratio = study->part[q] / study->part[k];
        const bool fits = level      ? point[q].step == point[k].step
                          : side < 0 ? ratio < told_apart
                                     : ratio * told_apart > 1;
        if (fits && point[q].level == point[k].level + level && isfinite(point[q].error) &&
            strcmp(point[q].method, point[k].method) == 0 &&
            strcmp(point[q].precision, point[k].precision) == 0 &&
            (best == NONE || fabs(log(ratio)) < fabs(log(study->part[best] / study->part[k]))))
            best = q;
    }
    return best;
}

/// Errors of step and mesh may cancel, and do so for these numbers only, so that neither is taken
/// for less than it is: order 1 in the step, e (1 - h'/h) of it is seen from a step h' to h; order
/// 2 in the mesh, 3/4 of it to the level above.
static double without_luck(const Study* study, int k) {
    const AdvicePoint* point = study->advice->point;
    const int shorter = neighbor(study, k, 0, -1), longer = neighbor(study, k, 0, 1);
    const int denser = neighbor(study, k, 1, 0), other = shorter != NONE ? shorter : longer;
    double error = point[k].error * (other == NONE && denser == NONE ? unknown : 1);
    if (other != NONE)
        error = fmax(error, apart(study, study->value[k], study->value[other]) /
                                fabs(1 - study->part[other] / study->part[k]));
    if (denser != NONE)
        error = fmax(error, apart(study, study->value[k], study->value[denser]) * 4 / 3);
    return error;
}

static void undo_luck(Study* study) {
    Advice* advice = study->advice;
    double* error = new_array(double, advice->count);
    for (int k = 0; k < advice->count; k++)
        error[k] = isfinite(advice->point[k].error) ? without_luck(study, k) : INFINITY;
    for (int k = 0; k < advice->count; k++)
        advice->point[k].error = error[k];
    free(error);
}

/// Four times as many points cost four times as much at least: a line whose method was too slow on
/// the level below is not begun.
static bool is_too_slow(const Study* study, const Line* line) {
    for (int k = 0; k < study->lines; k++) {
        const Line* other = &study->line[k];
        if (other->method == line->method && other->level == line->level - 1 &&
            isfinite(other->cost) && 4 * other->cost > cost_most)
            return true;
    }
    return false;
}

static bool time_again(Study* study, AdvicePoint* point, Fault* fault) {
    double value[ADVISE_OUTPUTS];
    Report report;
    if (!run_one(study, point->method, point->precision, point->level, point->step, value, &report,
                 fault))
        return false;
    point->ms = fmin(point->ms, report.ms / ADVISE_FPS);
    report_free(&report);
    return true;
}

static bool measure(Study* study, Fault* fault) {
    if (!find_reference(study, fault))
        return false;
    add_lines(study);
    // float and double stand in pairs: double where a float's rounding could be what is left
    for (int k = 0; k < study->lines; k++) {
        Line* line = &study->line[k];
        const Line* before = k % 2 ? line - 1 : NULL;
        line->halving = before ? before->closest : 0;
        if (is_too_slow(study, line))
            line->cost = cost_most;
        line->done = isfinite(line->cost) || (before && !(before->best < rounding_most));
        while (!line->done)
            if (!go_on(study, line, fault))
                return false;
    }
    undo_luck(study);

    // what may be picked deserves a good clock
    Advice* advice = study->advice;
    const AdvicePoint** front = new_array(const AdvicePoint*, advice->count);
    bool good = true;
    for (int round = 0; good && round < RETIMES; round++) {
        const int count = advise_front(advice, front);
        for (int k = 0; good && k < count; k++)
            good = time_again(study, &advice->point[front[k] - advice->point], fault);
    }
    free(front);
    return good;
}

bool advise_measure(const char* scene, const SceneSet* set, int set_count, Advice* advice,
                    Fault* fault) {
    WorldDef def;
    *advice = (Advice){0};
    Study study = {.scene = scene, .set = set, .set_count = set_count, .advice = advice};
    if (!scene_load(scene, set, set_count, &def, fault) || !world_open(&study.world, &def, fault))
        return false;
    study.outputs = scene_outputs(&study.world.def);
    advice->outputs = (int)study.outputs;
    bool good = study.outputs > 0 && study.outputs <= ADVISE_OUTPUTS;
    if (!good)
        fault_set(fault, study.world.def.file,
                  "it is not about outputs that an error could be of; see balloon needs");
    good = good && measure(&study, fault);
    free(study.line);
    free(study.value);
    free(study.part);
    world_close(&study.world);
    if (!good)
        advise_free(advice);
    return good;
}
