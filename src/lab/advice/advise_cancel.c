#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "lab/advice/advise_study.h"

/// Two steps with a ratio above this are too similar for an estimate from their difference. [1]
static const double max_step_ratio = 0.9;
/// Factor on the measured error of a point without neighbors. [1]
static const double safety_factor = 2;

/// Difference between the values of two points, in the norm of the error [1].
static double difference(const Study* study, const double value[], const double other[]) {
    double max = 0;
    for (unsigned k = 0; k < study->outputs; k++)
        max = fmax(max, fabs(value[k] - other[k]) / fabs(study->advice->reference[k]));
    return max;
}

/// A point with the method and precision of point k that reached its end: if `finer`, one
/// refinement finer with the same step, else at the same refinement with the nearest shorter (side
/// < 0) or longer step. NONE: there is no such point.
static int neighbor(const Study* study, int k, int finer, int side) {
    const AdvicePoint* point = study->advice->point;
    int best = NONE;
    for (int q = 0; q < study->advice->count; q++) {
        const double ratio = study->substep[q] / study->substep[k];
        const bool fits = finer      ? point[q].step == point[k].step
                          : side < 0 ? ratio < max_step_ratio
                                     : ratio * max_step_ratio > 1;
        if (fits && point[q].refinement == point[k].refinement + finer &&
            isfinite(point[q].error) && strcmp(point[q].method, point[k].method) == 0 &&
            strcmp(point[q].precision, point[k].precision) == 0 &&
            (best == NONE ||
             fabs(log(ratio)) < fabs(log(study->substep[best] / study->substep[k]))))
            best = q;
    }
    return best;
}

/// The errors of step and mesh can cancel at one point by chance, so each is also estimated alone,
/// and the largest of the three counts. An error e of order 1 in the step changes by e (1 - h'/h)
/// from a step h to h'; one of order 2 in the mesh changes by 3/4 e to the next finer mesh.
static double estimated_error(const Study* study, int k) {
    const AdvicePoint* point = study->advice->point;
    const int shorter = neighbor(study, k, 0, -1), longer = neighbor(study, k, 0, 1);
    const int denser = neighbor(study, k, 1, 0), other = shorter != NONE ? shorter : longer;
    double error = point[k].error * (other == NONE && denser == NONE ? safety_factor : 1);
    if (other != NONE)
        error = fmax(error, difference(study, study->value[k], study->value[other]) /
                                fabs(1 - study->substep[other] / study->substep[k]));
    if (denser != NONE)
        error = fmax(error, difference(study, study->value[k], study->value[denser]) * 4 / 3);
    return error;
}

void study_undo_cancellation(const Study* study) {
    Advice* advice = study->advice;
    double* error = new_array(double, advice->count);
    for (int k = 0; k < advice->count; k++)
        error[k] = isfinite(advice->point[k].error) ? estimated_error(study, k) : INFINITY;
    for (int k = 0; k < advice->count; k++)
        advice->point[k].error = error[k];
    free(error);
}
