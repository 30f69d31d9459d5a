#include <math.h>
#include <string.h>

#include "base/clock.h"
#include "lab/advice/advise_study.h"

enum { FINEST_REFERENCE = 2, REFERENCE_POINTS_MAX = 3000 };

/// Of scenes a little off nothing is promised closer than this. [1]
static const double closest_promise = 1e-4;
/// Nor than this, where there is no time for a reference but the scene's own run. [1]
static const double own_promise = 0.02;
/// Share of the measurement's time that the reference may take. [1]
static const double time_share = 0.5;
/// One more level of an explicit method: four times the points, half the step. [1]
static const double level_cost = 8;
/// A step h of unknown parts, one of the same length, and its half. [runs at h]
static const double runs_on_level = 4;

static bool run_own(const Study* study, int level, double step, double value[], Report* report,
                    Fault* fault) {
    const AdvicePoint point = advise_point(study->world.method->name, "double", level, step);
    return study_run(study, &point, study->seconds, 0, study_time_left(study, time_share), value,
                     report, fault);
}

static double own_step(const Study* study) {
    return fmin(study->world.step, 1 / ADVISE_FPS);
}

/// The limit of a vanishing step by the scene's own method on a level, 2 v(h/2) - v(h); NAN where
/// the time is over before.
static bool vanishing_step(const Study* study, int level, double value[], Fault* fault) {
    Report report;
    double step = own_step(study), coarse[ADVISE_OUTPUTS];
    if (!run_own(study, level, step, coarse, &report, fault))
        return false;
    step /= 2 * exp2(ceil(log2(report.substeps)));
    report_free(&report);
    if (!run_own(study, level, step, coarse, &report, fault))
        return false;
    report_free(&report);
    if (!run_own(study, level, step / 2, value, &report, fault))
        return false;
    report_free(&report);
    for (unsigned k = 0; k < study->outputs; k++)
        value[k] = 2 * value[k] - coarse[k];
    return true;
}

/// The finest level on which there is time for three runs, of the cost [s] of the scene's own.
static int finest_level(const Study* study, double cost) {
    const double time = study_time_left(study, time_share);
    int fine = 0;
    while (fine < FINEST_REFERENCE && study_points_at(study, fine + 1) > 0 &&
           study_points_at(study, fine + 1) <= REFERENCE_POINTS_MAX &&
           cost * runs_on_level * pow(level_cost, fine + 1) < time)
        fine++;
    while (cost * runs_on_level * pow(level_cost, fine) > time &&
           study_points_at(study, fine - 1) > 0)
        fine--;
    return fine;
}

static bool are_finite(const double value[], unsigned count) {
    for (unsigned k = 0; k < count; k++)
        if (!isfinite(value[k]))
            return false;
    return true;
}

/// Two levels give that of a vanishing edge, order 2.
static void extrapolate(Advice* advice, const double finest[], const double coarser[]) {
    for (int k = 0; k < advice->outputs; k++) {
        advice->reference[k] = finest[k] + (finest[k] - coarser[k]) / 3;
        advice->floor = fmax(advice->floor, 0.1 * fabs(finest[k] - advice->reference[k]) /
                                                fabs(advice->reference[k]));
    }
}

bool study_find_reference(Study* study, Fault* fault) {
    Advice* advice = study->advice;
    Report report;
    double own[ADVISE_OUTPUTS], finest[ADVISE_OUTPUTS], coarser[ADVISE_OUTPUTS];
    const double before = clock_seconds(CLOCK_MONOTONIC);
    if (!run_own(study, 0, own_step(study), own, &report, fault))
        return false;
    report_free(&report);
    const int fine = finest_level(study, clock_seconds(CLOCK_MONOTONIC) - before);
    if (!vanishing_step(study, fine, finest, fault))
        return false;
    memcpy(coarser, finest, sizeof coarser);
    if (study_points_at(study, fine - 1) > 0 && !vanishing_step(study, fine - 1, coarser, fault))
        return false;
    advice->floor = closest_promise;
    if (!are_finite(finest, study->outputs)) {
        advice->floor = own_promise;
        memcpy(finest, own, sizeof finest);
    }
    extrapolate(advice, finest, are_finite(coarser, study->outputs) ? coarser : finest);
    for (unsigned k = 0; k < study->outputs; k++)
        if (!(fabs(advice->reference[k]) > 0))
            return fault_set(fault, study->world.def.file,
                             "about: %s has no value to compare with at %g s, or none within %g s "
                             "of measuring",
                             study->world.def.about[k].output, study->world.def.about[k].at,
                             time_share * ADVISE_SECONDS_MAX);
    return true;
}
