#include <math.h>
#include <string.h>

#include "base/clock.h"
#include "lab/advice/advise_study.h"

enum { FINEST_REFERENCE = 2, REFERENCE_POINTS_MAX = 3000 };

/// Minimum floor: advice is also used for scenes with slightly different numbers. [1]
static const double min_floor = 1e-4;
/// Floor if there is no time for a reference, and the scene's own run must stand in for it. [1]
static const double own_floor = 0.02;
/// Share of the measurement's time for the reference. [1]
static const double time_share = 0.5;
/// Cost ratio of one refinement by an explicit method: four times the points, half the step. [1]
static const double refinement_cost = 8;
/// Cost of the runs at one refinement: two of step h, one of h/2. [runs at h]
static const double runs_per_refinement = 4;

static bool run_own(const Study* study, int refinement, double step, double value[], Report* report,
                    Fault* fault) {
    const AdvicePoint point = advise_point(study->world.method->name, "double", refinement, step);
    return study_run(study, &point, study->seconds, 0, study_time_remaining(study, time_share),
                     value, report, fault);
}

static double own_step(const Study* study) {
    return fmin(study->world.step, 1 / ADVISE_FPS);
}

/// The values extrapolated to step 0 at a refinement, 2 v(h/2) - v(h), by the scene's own method;
/// NAN if the time did not suffice. A first run shows into how many substeps the guard divides the
/// step.
static bool extrapolate_step(const Study* study, int refinement, double value[], Fault* fault) {
    Report report;
    double step = own_step(study), coarse[ADVISE_OUTPUTS];
    if (!run_own(study, refinement, step, coarse, &report, fault))
        return false;
    step /= 2 * exp2(ceil(log2(report.substeps)));
    report_free(&report);
    if (!run_own(study, refinement, step, coarse, &report, fault))
        return false;
    report_free(&report);
    if (!run_own(study, refinement, step / 2, value, &report, fault))
        return false;
    report_free(&report);
    for (unsigned k = 0; k < study->outputs; k++)
        value[k] = 2 * value[k] - coarse[k];
    return true;
}

/// The finest refinement for whose runs the time suffices; cost: of a run of the scene itself [s].
static int finest_refinement(const Study* study, double cost) {
    const double time = study_time_remaining(study, time_share);
    int fine = 0;
    while (fine < FINEST_REFERENCE && study_points_at(study, fine + 1) > 0 &&
           study_points_at(study, fine + 1) <= REFERENCE_POINTS_MAX &&
           cost * runs_per_refinement * pow(refinement_cost, fine + 1) < time)
        fine++;
    while (cost * runs_per_refinement * pow(refinement_cost, fine) > time &&
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

/// Extrapolate to edge length 0 from two refinements, by order 2.
static void extrapolate_edge(Advice* advice, const double finest[], const double coarser[]) {
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
    const int fine = finest_refinement(study, clock_seconds(CLOCK_MONOTONIC) - before);
    if (!extrapolate_step(study, fine, finest, fault))
        return false;
    memcpy(coarser, finest, sizeof coarser);
    if (study_points_at(study, fine - 1) > 0 && !extrapolate_step(study, fine - 1, coarser, fault))
        return false;
    advice->floor = min_floor;
    if (!are_finite(finest, study->outputs)) {
        advice->floor = own_floor;
        memcpy(finest, own, sizeof finest);
    }
    extrapolate_edge(advice, finest, are_finite(coarser, study->outputs) ? coarser : finest);
    for (unsigned k = 0; k < study->outputs; k++)
        if (!(fabs(advice->reference[k]) > 0))
            return fault_set(fault, study->world.def.file,
                             "about: %s has no value to compare with at %g s, or none within %g s "
                             "of measuring",
                             study->world.def.about[k].output, study->world.def.about[k].at,
                             time_share * ADVISE_SECONDS_MAX);
    return true;
}
