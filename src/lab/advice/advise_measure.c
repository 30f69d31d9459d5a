#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/memory.h"
#include "lab/advice/advise_study.h"

enum { COARSEST = -3, FINEST = 2, HALVINGS = 12, RETIMES = 2 };

/// Finer meshes cost too much for their accuracy. [particles]
static const int max_points = 12000;
/// Maximum error that may be due to rounding of floats: above it double is not tried. [1]
static const double max_rounding = 2e-3;
/// If a step's error is within this factor of the best one, shorter steps gain nothing. A larger
/// error does not end the search: in a moving scene single steps can be worse. [1]
static const double progress = 0.8;
/// Minimum simulated time of a run: shorter ones measure the clock's resolution and cold caches. A
/// longer run is preceded by a short run of this length. [s]
static const double min_seconds = 0.3;
/// A candidate is dropped if its short run costs this many times ADVISE_COST_MAX. [1]
static const double short_run_margin = 3;
/// Maximum CPU time to load a scene. [s]
static const double max_load = 1;
/// Share of the time in which points are measured; the rest is for repeated timing. [1]
static const double points_share = 0.85;

// --- the points ----------------------------------------------------------------------------------

static bool is_refused(const Study* study, const Method* method) {
    for (int b = 0; b < study->world.balloon_count; b++)
        if (method_refuses(method, &study->world.balloon[b].body))
            return true;
    return false;
}

/// Add two lines, for float and double.
static void add_pair(Study* study, const Method* method, int refinement) {
    static const char* const precision[] = {"float", "double"};
    for (int p = 0; p < 2; p++)
        study->line[study->lines++] = (Line){.method = method,
                                             .precision = precision[p],
                                             .refinement = refinement,
                                             .best = INFINITY,
                                             .cost = INFINITY};
}

/// The scene's own method on its own mesh is first, so that the best point is never worse than the
/// scene itself; the others follow from coarse to fine meshes.
static void add_lines(Study* study) {
    const Method* own = study->world.method;
    study->line = new_array(Line, (FINEST - COARSEST + 1) * method_count * 2);
    add_pair(study, own, 0);
    for (int refinement = COARSEST; refinement <= FINEST; refinement++) {
        const int points = study_points_at(study, refinement);
        for (int m = 0; points > 0 && points <= max_points && m < method_count; m++)
            if (!is_refused(study, method_table[m]) && (refinement != 0 || method_table[m] != own))
                add_pair(study, method_table[m], refinement);
    }
    const int capacity = study->lines * (HALVINGS + 1);
    study->advice->point = new_array(AdvicePoint, capacity);
    study->value = new_array(double[ADVISE_OUTPUTS], capacity);
    study->substep = new_array(double, capacity);
}

static double error_of(const Study* study, const double value[]) {
    double max = 0;
    for (unsigned k = 0; k < study->outputs; k++) {
        const double error =
            fabs(value[k] - study->advice->reference[k]) / fabs(study->advice->reference[k]);
        max = error <= max ? max : isfinite(error) ? error : INFINITY;
    }
    return max;
}

/// Try the first part of a long run: dropped if it costs far more than ADVISE_COST_MAX or was
/// ended.
static bool is_dropped(const Study* study, Line* line, const AdvicePoint* point, bool* dropped,
                       Fault* fault) {
    Report report;
    double value[ADVISE_OUTPUTS];
    *dropped = false;
    if (study->seconds < 4 * min_seconds)
        return true; // the run itself is about as short
    const double max_cost = short_run_margin * ADVISE_COST_MAX;
    if (!study_run(study, point, min_seconds, max_cost / 1e3 * min_seconds + max_load,
                   study_time_remaining(study, points_share), value, &report, fault))
        return false;
    *dropped = !(report.ms <= max_cost);
    if (*dropped)
        line->cost = isfinite(report.ms) ? report.ms : max_cost;
    report_free(&report);
    return true;
}

static void add_point(Study* study, const AdvicePoint* point, const Report* report,
                      const double value[]) {
    const int at = study->advice->count++;
    memcpy(study->value[at], value, sizeof study->value[at]);
    study->substep[at] = point->step / report->substeps;
    AdvicePoint* added = &study->advice->point[at];
    *added = *point;
    added->error = report->ended ? error_of(study, value) : INFINITY;
    added->ms = report->ms / ADVISE_FPS;
}

/// Choose the step after the last measured point, or end the line.
static void find_next(const Study* study, Line* line, const Report* report) {
    const AdvicePoint* point = &study->advice->point[study->advice->count - 1];
    line->cost = fmin(line->cost, report->ms);
    const bool stagnates = isfinite(point->error) && point->error >= progress * line->best &&
                           point->error * progress <= line->best;
    if (point->error < line->best) {
        line->best = point->error;
        line->best_halving = line->halving;
    }
    line->halving += report->substeps > 1 ? (int)ceil(log2(report->substeps)) : 1;
    line->done = line->halving > HALVINGS || stagnates ||
                 (report->ended && report->ms * (report->substeps > 1 ? 1 : 2) > ADVISE_COST_MAX);
}

/// Measure the line's next step and choose the one after it.
static bool measure_step(Study* study, Line* line, Fault* fault) {
    Report report;
    double value[ADVISE_OUTPUTS];
    const AdvicePoint point = advise_point(line->method->name, line->precision, line->refinement,
                                           1 / ADVISE_FPS / exp2(line->halving));
    if (!is_dropped(study, line, &point, &line->done, fault))
        return false;
    if (line->done)
        return true;
    if (!study_run(study, &point, study->seconds, ADVISE_COST_MAX / 1e3 * study->seconds + max_load,
                   study_time_remaining(study, points_share), value, &report, fault))
        return false;
    if (isfinite(report.ms)) {
        add_point(study, &point, &report, value);
        find_next(study, line, &report);
    } else { // the run was ended at its limit, or refused
        line->cost = fmin(line->cost, ADVISE_COST_MAX);
        line->done = true;
    }
    report_free(&report);
    return true;
}

/// Four times as many points cost at least four times as much: a line is not begun if its method
/// was too slow for that at the next coarser refinement.
static bool is_too_slow(const Study* study, const Line* line) {
    for (int k = 0; k < study->lines; k++) {
        const Line* other = &study->line[k];
        if (other->method == line->method && other->refinement == line->refinement - 1 &&
            isfinite(other->cost) && 4 * other->cost > ADVISE_COST_MAX)
            return true;
    }
    return false;
}

static bool time_again(const Study* study, AdvicePoint* point, Fault* fault) {
    double value[ADVISE_OUTPUTS];
    Report report;
    if (!study_run(study, point, study->seconds, 0, study_time_remaining(study, 1), value, &report,
                   fault))
        return false;
    if (report.ms >= 0)
        point->ms = fmin(point->ms, report.ms / ADVISE_FPS);
    report_free(&report);
    return true;
}

/// Repeat the timing of the points that advice may choose.
static bool time_front(Study* study, Fault* fault) {
    Advice* advice = study->advice;
    const AdvicePoint** front = new_array(const AdvicePoint*, advice->count);
    bool good = true;
    for (int round = 0; good && round < RETIMES; round++) {
        const int count = advise_front(advice, front);
        for (int k = 0; good && k < count && study_time_remaining(study, 1) > 0; k++)
            good = time_again(study, &advice->point[front[k] - advice->point], fault);
    }
    free(front);
    return good;
}

/// On a terminal, print the number of points and the maximum remaining time.
static void say_progress(const Study* study) {
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\radvice: %d points measured, at most %.0f s more ", study->advice->count,
                study_time_remaining(study, 1));
}

static bool measure_line(Study* study, int k, Fault* fault) {
    // double is measured after float, and only where float's error may be due to rounding
    Line* line = &study->line[k];
    const Line* before = k % 2 ? line - 1 : NULL;
    line->halving = before ? before->best_halving : 0;
    if (is_too_slow(study, line))
        line->cost = ADVISE_COST_MAX;
    line->done = isfinite(line->cost) || (before && !(before->best < max_rounding));
    while (!line->done && study_time_remaining(study, points_share) > 0) {
        say_progress(study);
        if (!measure_step(study, line, fault))
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
    study_undo_cancellation(study);
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
                   .seconds = min_seconds,
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
    free(study.substep);
    world_close(&study.world);
    if (!good)
        advise_free(advice);
    return good;
}
