#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/memory.h"
#include "lab/advice/advise_study.h"

enum { COARSEST = -3, FINEST = 2, HALVINGS = 12, RETIMES = 2 };

/// A mesh of more points is too slow for what it gains. [1]
static const int points_most = 12000;
/// Errors above this are not those of a float's rounding. [1]
static const double rounding_most = 2e-3;
/// An error that is within this factor of the best stands still: shorter steps gain nothing. What
/// falls between two steps of a moving scene may be worse for once. [1]
static const double progress = 0.8;
/// Shorter runs are lost in the clock and in cold caches. A longer run is tried for as long. [s]
static const double seconds_least = 0.3;
/// A candidate whose try costs this many times the most is dropped. [1]
static const double try_margin = 3;
/// CPU time that a program needs to load a scene, at most. [s]
static const double load_most = 1;
/// Share of the time in which points are measured; the rest is for better clocks. [1]
static const double points_share = 0.85;

// --- the points ----------------------------------------------------------------------------------

static bool is_refused(const Study* study, const Method* method) {
    for (int b = 0; b < study->world.balloon_count; b++)
        if (method_refuses(method, &study->world.balloon[b].body))
            return true;
    return false;
}

/// A pair of lines, float and double.
static void add_pair(Study* study, const Method* method, int level) {
    static const char* const precision[] = {"float", "double"};
    for (int p = 0; p < 2; p++)
        study->line[study->lines++] = (Line){.method = method,
                                             .precision = precision[p],
                                             .level = level,
                                             .best = INFINITY,
                                             .cost = INFINITY};
}

/// The scene's own method on its own mesh comes first, so that the best so far is no worse than the
/// scene is; then the cheap ones, on coarse meshes.
static void add_lines(Study* study) {
    const Method* own = study->world.method;
    study->line = new_array(Line, (FINEST - COARSEST + 1) * method_count * 2);
    add_pair(study, own, 0);
    for (int level = COARSEST; level <= FINEST; level++) {
        const int points = study_points_at(study, level);
        for (int m = 0; points > 0 && points <= points_most && m < method_count; m++)
            if (!is_refused(study, method_table[m]) && (level != 0 || method_table[m] != own))
                add_pair(study, method_table[m], level);
    }
    const int capacity = study->lines * (HALVINGS + 1);
    study->advice->point = new_array(AdvicePoint, capacity);
    study->value = new_array(double[ADVISE_OUTPUTS], capacity);
    study->part = new_array(double, capacity);
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

/// Sure to cost more than the most: a try of its beginning did, by far, or was ended.
static bool is_dropped(const Study* study, Line* line, const AdvicePoint* point, bool* dropped,
                       Fault* fault) {
    Report report;
    double value[ADVISE_OUTPUTS];
    *dropped = false;
    if (study->seconds < 4 * seconds_least)
        return true; // the run itself is about as short
    const double most = try_margin * ADVISE_COST_MAX;
    if (!study_run(study, point, seconds_least, most / 1e3 * seconds_least + load_most,
                   study_time_left(study, points_share), value, &report, fault))
        return false;
    *dropped = !(report.ms <= most);
    if (*dropped)
        line->cost = isfinite(report.ms) ? report.ms : most;
    report_free(&report);
    return true;
}

static void add_point(Study* study, const AdvicePoint* point, const Report* report,
                      const double value[]) {
    const int at = study->advice->count++;
    memcpy(study->value[at], value, sizeof study->value[at]);
    study->part[at] = point->step / report->substeps;
    AdvicePoint* added = &study->advice->point[at];
    *added = *point;
    added->error = report->ended ? error_of(study, value) : INFINITY;
    added->ms = report->ms / ADVISE_FPS;
}

/// What comes after the point that was measured last.
static void find_next(const Study* study, Line* line, const Report* report) {
    const AdvicePoint* point = &study->advice->point[study->advice->count - 1];
    line->cost = fmin(line->cost, report->ms);
    const bool idle = isfinite(point->error) && point->error >= progress * line->best &&
                      point->error * progress <= line->best;
    if (point->error < line->best) {
        line->best = point->error;
        line->closest = line->halving;
    }
    line->halving += report->substeps > 1 ? (int)ceil(log2(report->substeps)) : 1;
    line->done = line->halving > HALVINGS || idle ||
                 (report->ended && report->ms * (report->substeps > 1 ? 1 : 2) > ADVISE_COST_MAX);
}

/// Measure the line's next step, and say which comes after it.
static bool go_on(Study* study, Line* line, Fault* fault) {
    Report report;
    double value[ADVISE_OUTPUTS];
    const AdvicePoint point = advise_point(line->method->name, line->precision, line->level,
                                           1 / ADVISE_FPS / exp2(line->halving));
    if (!is_dropped(study, line, &point, &line->done, fault))
        return false;
    if (line->done)
        return true;
    if (!study_run(study, &point, study->seconds,
                   ADVISE_COST_MAX / 1e3 * study->seconds + load_most,
                   study_time_left(study, points_share), value, &report, fault))
        return false;
    if (isfinite(report.ms)) {
        add_point(study, &point, &report, value);
        find_next(study, line, &report);
    } else { // it was ended, or refused
        line->cost = fmin(line->cost, ADVISE_COST_MAX);
        line->done = true;
    }
    report_free(&report);
    return true;
}

/// Four times as many points cost four times as much at least: a line whose method was too slow on
/// the level below is not begun.
static bool is_too_slow(const Study* study, const Line* line) {
    for (int k = 0; k < study->lines; k++) {
        const Line* other = &study->line[k];
        if (other->method == line->method && other->level == line->level - 1 &&
            isfinite(other->cost) && 4 * other->cost > ADVISE_COST_MAX)
            return true;
    }
    return false;
}

static bool time_again(const Study* study, AdvicePoint* point, Fault* fault) {
    double value[ADVISE_OUTPUTS];
    Report report;
    if (!study_run(study, point, study->seconds, 0, study_time_left(study, 1), value, &report,
                   fault))
        return false;
    if (report.ms >= 0)
        point->ms = fmin(point->ms, report.ms / ADVISE_FPS);
    report_free(&report);
    return true;
}

/// What may be picked deserves a good clock.
static bool time_front(Study* study, Fault* fault) {
    Advice* advice = study->advice;
    const AdvicePoint** front = new_array(const AdvicePoint*, advice->count);
    bool good = true;
    for (int round = 0; good && round < RETIMES; round++) {
        const int count = advise_front(advice, front);
        for (int k = 0; good && k < count && study_time_left(study, 1) > 0; k++)
            good = time_again(study, &advice->point[front[k] - advice->point], fault);
    }
    free(front);
    return good;
}

/// On a terminal: how far it is, and when it ends at the latest.
static void say_progress(const Study* study) {
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\radvice: %d points measured, at most %.0f s more ", study->advice->count,
                study_time_left(study, 1));
}

static bool measure_line(Study* study, int k, Fault* fault) {
    // double where a float's rounding could be what is left
    Line* line = &study->line[k];
    const Line* before = k % 2 ? line - 1 : NULL;
    line->halving = before ? before->closest : 0;
    if (is_too_slow(study, line))
        line->cost = ADVISE_COST_MAX;
    line->done = isfinite(line->cost) || (before && !(before->best < rounding_most));
    while (!line->done && study_time_left(study, points_share) > 0) {
        say_progress(study);
        if (!go_on(study, line, fault))
            return false;
    }
    return true;
}

static bool measure(Study* study, Fault* fault) {
    say_progress(study);
    if (!study_find_reference(study, fault))
        return false;
    add_lines(study);
    for (int k = 0; k < study->lines; k++)
        if (!measure_line(study, k, fault))
            return false;
    study_undo_luck(study);
    const bool good = time_front(study, fault);
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%60s\r", "");
    return good;
}

bool advise_measure(const char* scene, const SceneSet* set, int set_count, Advice* advice,
                    Fault* fault) {
    WorldDef def;
    *advice = (Advice){0};
    Study study = {.scene = scene,
                   .set = set,
                   .set_count = set_count,
                   .seconds = seconds_least,
                   .start = clock_seconds(CLOCK_MONOTONIC),
                   .advice = advice};
    if (!scene_load(scene, set, set_count, &def, fault) || !world_open(&study.world, &def, fault))
        return false;
    study.outputs = scene_outputs(&study.world.def);
    for (unsigned k = 0; k < study.outputs; k++)
        study.seconds = fmax(study.seconds, study.world.def.about[k].at);
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
