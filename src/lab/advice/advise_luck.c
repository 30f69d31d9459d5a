#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "lab/advice/advise_study.h"

/// Steps nearer to each other than this tell nothing of each other's errors. [1]
static const double told_apart = 0.9;
/// What an error may be more than it seems where no neighbor tells. [1]
static const double unknown = 2;

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

void study_undo_luck(const Study* study) {
    Advice* advice = study->advice;
    double* error = new_array(double, advice->count);
    for (int k = 0; k < advice->count; k++)
        error[k] = isfinite(advice->point[k].error) ? without_luck(study, k) : INFINITY;
    for (int k = 0; k < advice->count; k++)
        advice->point[k].error = error[k];
    free(error);
}
