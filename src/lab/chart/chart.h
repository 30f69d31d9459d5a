/// `balloon chart`: speed against accuracy, every method on the same scenes.
///
/// A point is one method x mesh x step x precision on one scene: the CPU time of its steps per
/// simulated second, one thread and no drawing, against its relative error at the same end time
/// with the same physical parameters. It is a run of this program, which anyone can repeat. Errors
/// come from a first run, which also warms up, the time is the median of three more.
///
/// DIR holds chart.csv, a row for each point; front.csv, the points that no other one of their
/// method on their skin, or none at all, beats in both; chart.md, for each scene the cheapest
/// method below 1 % error; and for each scene NAME.gp, from which gnuplot draws NAME.svg and
/// NAME.png again. All but the times is the same to the last bit whenever and wherever it is done.
#ifndef BALLOON_LAB_CHART_CHART_H
#define BALLOON_LAB_CHART_CHART_H

#include "lab/chart/chart_case.h"

typedef struct ChartOptions {
    const char* out;        ///< folder for the results
    const char* only;       ///< name of a scene or letter of a case; NULL: all
    ChartExtent extent;     ///< quick, full or all
    const char* program[2]; ///< to run, of each precision's state: float, double
} ChartOptions;

/// One point, a row of chart.csv.
typedef struct ChartPoint {
    const ChartCase* chart;
    const ChartMeasure* measure;
    char name[64];   ///< of the scene and, where there are several, of what is measured
    char method[32]; ///< "bullet": the peer
    char skin[16];   ///< springs, membrane, or the peer's links
    char law[32];    ///< of the springs, or the membrane's material
    int vertices;
    double step; ///< [s]
    const char* precision;
    int launch; ///< number of its run; NONE: the method does not take this scene

    double ms; ///< CPU time per simulated second [ms]
    double measured, truth, error;
    double floor; ///< the truth's own error, 0 of closed forms
    bool apart;   ///< no answer to what the case asks
    bool stable;  ///< it came to its end
    int parts;    ///< in which the guard had a step made
    char hash[24];
    bool best_of_line; ///< none of its method on its skin is both cheaper and closer
    bool best;         ///< nor is any other
} ChartPoint;

enum { CHART_REFERENCES = 4 }; ///< runs of a case without a closed form

/// All points of a chart and the runs that they want; points may share one.
typedef struct ChartPlan {
    ChartPoint* point;
    int points;
    Launch* launch;
    int launches;
    Launch* reference; ///< four in a row for each case that needs them, in the table's order
    int references;
    const ChartCase** referred; ///< [references / 4] the cases
} ChartPlan;

bool chart_plan(ChartPlan* plan, const ChartOptions* options, Fault* fault);
void chart_plan_free(ChartPlan* plan);

/// Do all runs, errors side by side and then times one after the other, and fill the points.
bool chart_measure(ChartPlan* plan, Fault* fault);

/// Bullet's own soft body.
extern const char chart_peer_name[];
bool chart_is_peer(const ChartPoint* point);

/// A line of a chart: one method on one skin.
bool chart_same_line(const ChartPoint* a, const ChartPoint* b);

/// The point after those that have this one's name, which stand together.
int chart_end(const ChartPlan* plan, int from);

/// chart.csv, front.csv and chart.md; the charts.
bool chart_write(const ChartPlan* plan, const char* folder, Fault* fault);
bool chart_draw(const ChartPlan* plan, const char* folder, Fault* fault);

/// All of that.
bool chart_run(const ChartOptions* options, Fault* fault);

#endif
