/// The measurement behind an advice: runs of the scene as candidates have it, within a time.
///
/// A run is ended when it is sure that its cost is above ADVISE_COST_MAX, or when the time of the
/// whole measurement is over; then the best so far is taken.
#ifndef BALLOON_LAB_ADVICE_ADVISE_STUDY_H
#define BALLOON_LAB_ADVICE_ADVISE_STUDY_H

#include "lab/advice/advise.h"
#include "lab/run/report.h"

extern const double ADVISE_SECONDS_MAX; ///< time of a whole measurement [s]
extern const double ADVISE_COST_MAX;    ///< CPU time per simulated second of a candidate [ms]

/// One method on one level in one precision: its steps are measured one after the other.
typedef struct Line {
    const Method* method;
    const char* precision;
    int level;
    int halving; ///< of the step to be measured next
    int closest; ///< of the least error
    double best; ///< least error so far
    double cost; ///< the least, per simulated second [ms]
    bool done;
} Line;

typedef struct Study {
    const char* scene;
    const SceneSet* set;
    int set_count;
    World world;    ///< the scene, before its first step
    double seconds; ///< simulated time of a run [s]
    double start;   ///< when the measurement began, of the monotonic clock [s]
    unsigned outputs;
    Line* line;
    int lines;
    Advice* advice;
    double (*value)[ADVISE_OUTPUTS]; ///< [capacity] of each point
    double* part;                    ///< [capacity] its step as the guard divided it [s]
} Study;

/// Time that remains of this share of the whole measurement's [s]; 0 where none does.
double study_time_left(const Study* study, double share);

/// Run the scene as a point has it for so many simulated seconds. value: NAN where the run did not
/// reach an output's time. The run is ended after cpu_max of CPU time [s], 0: the launch's default,
/// and after wall_max [s]; then the report's `ms` is NAN.
bool study_run(const Study* study, const AdvicePoint* point, double seconds, double cpu_max,
               double wall_max, double value[], Report* report, Fault* fault);

/// Particles of the scene on a level of refinement; 0 where there is no such level.
int study_points_at(const Study* study, int level);

/// Fill the advice's reference and floor (advise_reference.c).
bool study_find_reference(Study* study, Fault* fault);

/// Put into each point's error what the neighboring points say of it (advise_luck.c).
void study_undo_luck(const Study* study);

AdvicePoint advise_point(const char* method, const char* precision, int level, double step);

#endif
