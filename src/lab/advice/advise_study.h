/// The measurement for an advice: runs of the scene with the settings of each candidate, in limited
/// time.
///
/// A run is ended as soon as its cost must exceed ADVISE_COST_MAX, or when the time of the whole
/// measurement is over; advice then chooses among the points measured so far.
#ifndef BALLOON_LAB_ADVICE_ADVISE_STUDY_H
#define BALLOON_LAB_ADVICE_ADVISE_STUDY_H

#include "lab/advice/advise.h"
#include "lab/run/report.h"

extern const double ADVISE_SECONDS_MAX; ///< maximum wall time of a measurement [s]
extern const double ADVISE_COST_MAX; ///< maximum CPU time per simulated second of a candidate [ms]

/// One method at one refinement in one precision: its steps are measured one after the other.
typedef struct Line {
    const Method* method;
    const char* precision;
    int refinement;
    int halving;      ///< number of halvings of 1/60 s for the step to be measured next
    int best_halving; ///< that of the smallest error
    double best;      ///< smallest error so far
    double cost;      ///< smallest so far: CPU time per simulated second [ms]
    bool done;        ///< no further step is measured
} Line;

typedef struct Study {
    const char* scene;
    const SceneSet* set;
    int set_count;
    World world;    ///< the scene, before its first step
    double seconds; ///< simulated time of a run [s]
    double start;   ///< monotonic clock at the start of the measurement [s]
    unsigned outputs;
    Line* line;
    int lines;
    Advice* advice;
    double (*value)[ADVISE_OUTPUTS]; ///< [capacity] outputs of each point
    double* substep;                 ///< [capacity] each point's step as the guard divided it [s]
} Study;

/// Remaining time [s] until this share of ADVISE_SECONDS_MAX has passed; 0 after that.
double study_time_remaining(const Study* study, double share);

/// Run the scene with the settings of a point for `seconds` of simulated time. value: the outputs,
/// NAN if the run did not reach an output's time. The run is ended after cpu_max of CPU time [s],
/// 0: the launch's default, or wall_max of wall time [s]; then the report's `ms` is NAN.
bool study_run(const Study* study, const AdvicePoint* point, double seconds, double cpu_max,
               double wall_max, double value[], Report* report, Fault* fault);

/// Number of particles of the scene at a refinement; 0 if a model has no such refinement.
int study_points_at(const Study* study, int refinement);

/// Fill the advice's reference and floor (advise_reference.c).
bool study_find_reference(Study* study, Fault* fault);

/// Raise the errors of points at which errors of step and mesh cancel (advise_cancel.c).
void study_undo_cancellation(const Study* study);

AdvicePoint advise_point(const char* method, const char* precision, int refinement, double step);

#endif
