/// `balloon chart`: speed against accuracy, every method on the same scenes.
///
/// A point is one method x mesh x step x precision on one scene: the CPU time of its steps per
/// simulated second, one thread and no drawing, against its relative error at the same end time
/// with the same physical parameters. It is a run of this program, which anyone can repeat. A first
/// run, which also warms up, gives the error; the time is the median of three more.
///
/// DIR holds chart.csv, a row for each point; front.csv, the Pareto front of each method on each
/// skin and that of all points; chart.md, for each scene the cheapest method below 1 % error; and
/// for each scene NAME.gp, from which gnuplot draws NAME.svg and NAME.png again. Everything but the
/// times is reproducible to the last bit.
#ifndef BALLOON_LAB_CHART_CHART_H
#define BALLOON_LAB_CHART_CHART_H

#include "lab/chart/chart_case.h"

typedef struct ChartOptions {
    const char* out;        ///< folder for the results
    const char* only;       ///< name of a scene or letter of a case; NULL: all
    ChartExtent extent;     ///< quick, full or all
    const char* program[2]; ///< paths of the programs for float and double
} ChartOptions;

/// One point, a row of chart.csv.
typedef struct ChartPoint {
    const ChartCase* chart;
    const ChartMeasure* measure;
    char name[64];   ///< the scene's and, if the case has several measures, the measure's
    char method[32]; ///< "bullet": the peer
    char skin[16];   ///< springs, membrane, or the peer's links
    char law[32];    ///< the springs' law, or the membrane's material
    int vertices;
    double step; ///< [s]
    const char* precision;
    int launch; ///< index of its run; NONE: the method refuses this scene

    double ms; ///< CPU time per simulated second [ms]
    double measured, truth, error;
    double floor; ///< error of the truth itself, 0 for closed forms
    bool apart;   ///< as in ChartSkin: not in the front of all points
    bool stable;  ///< the run reached its end
    int substeps; ///< largest number of substeps that the guard made of a step
    char hash[24];
    bool best_of_line; ///< on the Pareto front of its method on its skin
    bool best;         ///< on the Pareto front of all points
} ChartPoint;

enum { CHART_REFERENCES = 4 }; ///< runs of a case without a closed form

/// All points of a chart and their runs; points may share a run.
typedef struct ChartPlan {
    ChartExtent extent; ///< which part of the whole chart was planned
    ChartPoint* point;
    int points;
    Launch* launch;
    int launches;
    Launch* reference; ///< CHART_REFERENCES for each case without a closed form, in table order
    int references;
    const ChartCase** referred; ///< [references / CHART_REFERENCES] the cases of these runs
} ChartPlan;

bool chart_plan(ChartPlan* plan, const ChartOptions* options, Fault* fault);
void chart_plan_free(ChartPlan* plan);

/// Make all runs, for errors in parallel, for times one at a time, and fill in the points.
bool chart_measure(ChartPlan* plan, Fault* fault);

/// The name of Bullet's own soft body in the column `method`.
extern const char chart_peer_name[];
bool chart_is_peer(const ChartPoint* point);

/// A line of a chart: one method on one skin.
bool chart_same_line(const ChartPoint* a, const ChartPoint* b);

/// One past the last point with the name of point `from`; points of one name are contiguous.
int chart_end(const ChartPlan* plan, int from);

/// Whether chart.csv, front.csv and chart.md may be written.
bool chart_may_write(const char* folder, Fault* fault);

/// Write chart.csv, front.csv and chart.md; draw the charts.
bool chart_write(const ChartPlan* plan, const char* folder, Fault* fault);
bool chart_draw(const ChartPlan* plan, const char* folder, Fault* fault);

/// Plan, measure, write and draw.
bool chart_run(const ChartOptions* options, Fault* fault);

#endif
