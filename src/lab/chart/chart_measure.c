#include <math.h>
#include <string.h>

#include "base/median.h"
#include "base/memory.h"
#include "lab/chart/chart.h"
#include "mesh/mesh.h"

enum { SIDE_BY_SIDE = 2, TIMES = 3 };

/// The relative error, or the absolute one if the truth is 0.
static double error_of(double measured, double truth) {
    return truth == 0 ? fabs(measured) : fabs(measured - truth) / fabs(truth);
}

static void take(ChartPoint* point, const Report* report) {
    point->stable = report->ended;
    point->substeps = report->substeps;
    point->measured =
        report->ended ? point->measure->measured(report, point->measure->at) : (double)NAN;
    point->error = error_of(point->measured, point->truth);
    snprintf(point->hash, sizeof point->hash, "%s", report->hash[0] ? report->hash : "-");
}

/// Richardson extrapolation to h = 0 of two methods of order 1, 2 m(h/2) - m(h): the first method
/// gives the truth, its difference from the second gives the truth's error.
static void take_references(ChartPlan* plan) {
    for (int r = 0; r < plan->references; r += CHART_REFERENCES) {
        for (int p = 0; p < plan->points; p++) {
            ChartPoint* point = &plan->point[p];
            if (point->chart != plan->referred[r / CHART_REFERENCES])
                continue;
            double value[CHART_REFERENCES];
            for (int k = 0; k < CHART_REFERENCES; k++) {
                Report report;
                report_read(&report, &plan->reference[r + k]);
                value[k] = point->measure->measured(&report, point->measure->at);
                report_free(&report);
            }
            point->truth = 2 * value[1] - value[0];
            point->floor = error_of(2 * value[3] - value[2], point->truth);
        }
    }
}

/// Read all columns but the times from the first runs.
static void take_errors(ChartPlan* plan) {
    for (int k = 0; k < plan->launches; k++) {
        Report report;
        report_read(&report, &plan->launch[k]);
        for (int p = 0; p < plan->points; p++)
            if (plan->point[p].launch == k)
                take(&plan->point[p], &report);
        report_free(&report);
    }
}

/// The times of one round, ms[k * TIMES + round]. It is a bug if a run ends in another state than
/// the first run of the same point.
static bool take_times(const ChartPlan* plan, int round, double* ms, Fault* fault) {
    for (int k = 0; k < plan->launches; k++) {
        Report report;
        report_read(&report, &plan->launch[k]);
        ms[k * TIMES + round] = report.ms;
        for (int p = 0; p < plan->points; p++)
            if (plan->point[p].launch == k && report.ended &&
                strcmp(plan->point[p].hash, report.hash) != 0)
                fault_set(fault, plan->point[p].name, "the same run ended in two states, %s and %s",
                          plan->point[p].hash, report.hash);
        report_free(&report);
    }
    return !fault->text[0];
}

/// Whether no other point of the same name (of_line: of the same line) dominates the point. Points
/// of another law than the case's are not in the front of all points.
static bool is_best(const ChartPlan* plan, const ChartPoint* point, bool of_line) {
    if (!point->stable || !isfinite(point->error) || (point->apart && !of_line))
        return false;
    for (int q = 0; q < plan->points; q++) {
        const ChartPoint* other = &plan->point[q];
        if (other->stable && (of_line || !other->apart) && strcmp(other->name, point->name) == 0 &&
            (!of_line || chart_same_line(other, point)) && other->ms < point->ms &&
            other->error <= point->error)
            return false;
    }
    return true;
}

static void find_best(ChartPlan* plan) {
    for (int p = 0; p < plan->points; p++) {
        plan->point[p].best_of_line = is_best(plan, &plan->point[p], true);
        plan->point[p].best = is_best(plan, &plan->point[p], false);
    }
}

bool chart_measure(ChartPlan* plan, Fault* fault) {
    if (!launch_all(plan->launch, plan->launches, SIDE_BY_SIDE, "errors", fault))
        return false;
    if (!launch_all(plan->reference, plan->references, SIDE_BY_SIDE, "references", fault))
        return false;
    take_references(plan);
    take_errors(plan);

    double* ms = new_array(double, TIMES * plan->launches);
    bool good = true;
    for (int round = 0; good && round < TIMES; round++)
        good = launch_all(plan->launch, plan->launches, 1, "times", fault) &&
               take_times(plan, round, ms, fault);
    for (int p = 0; good && p < plan->points; p++)
        if (plan->point[p].launch != NONE)
            plan->point[p].ms = median(ms + plan->point[p].launch * TIMES, TIMES);
    free(ms);
    find_best(plan);
    return good;
}
