/// `balloon advise SCENE`: the cheapest way that is close enough, or the closest that is cheap
/// enough, from runs measured on this machine.
///
/// A point is one method x mesh level x step x precision on the scene, guard on, run by the program
/// itself:
///
///     error   max over the outputs of |value - reference| / |reference|                      [1]
///     cost    CPU time of stepping for a frame of 1/60 s, the least of the runs              [ms]
///     promise ADVISE_MARGIN error + floor                                                    [1]
///
/// An error is never taken for less than what the step's and the mesh's parts of it are alone,
/// which neighboring points tell: that they cancel is luck. The reference is what two finer runs
/// of the scene's own method tell of no step at all, order 1, and two levels of the mesh of endless
/// fineness, order 2; the floor is a tenth of how far the finest run is off that, 1e-4 at least.
/// Steps are 1/60 s halved again and again, from where the guard does not split them, until the
/// error stands still or a second costs 25 ms a frame; a run that is sure to cost more is ended. The
/// whole takes ADVISE_SECONDS_MAX at most: then what was measured until then is all there is.
///
/// Points are kept where the system keeps caches, and hold for every scene of the same words whose
/// numbers are within a fifth, on the same machine, for the same build of the program.
#ifndef BALLOON_LAB_ADVICE_ADVISE_H
#define BALLOON_LAB_ADVICE_ADVISE_H

#include "lab/run/overrides.h"
#include "world/world.h"

/// A comment by which a scene that advice wrote is known.
#define ADVISE_MARK "# What was put in its place:"

enum { ADVISE_OUTPUTS = 16 }; ///< that a scene may be about

extern const double ADVISE_MARGIN; ///< error that may be, over error that was measured [1]
extern const double ADVISE_FPS;    ///< frames that a second's cost is spread over [1/s]

typedef struct AdvicePoint {
    char method[24];
    char precision[8];
    int level;    ///< of the mesh, against the scene's own (lab/run/refinement.h)
    double step;  ///< [s]
    double error; ///< measured [1]; INFINITY: it went bad
    double ms;    ///< of a frame [ms]
} AdvicePoint;

typedef struct Advice {
    AdvicePoint* point; ///< [count] owned
    int count;
    double floor; ///< what is not known of the reference [1]
    int outputs;
    double reference[ADVISE_OUTPUTS]; ///< of the scene that was measured
} Advice;

/// The points of a scene, from the cache or measured now and then kept. `fresh`: measured anyway.
/// A scene that is about none is a fault.
bool advise_points(const char* scene, const SceneSet* set, int set_count, bool fresh,
                   Advice* advice, Fault* fault);
void advise_free(Advice* advice);

/// The largest error to be expected of a point [1].
double advise_promise(const Advice* advice, const AdvicePoint* point);

/// The cheapest point that promises `error`, or with error 0 the closest within `ms`. NULL: none;
/// `best` is then what comes nearest.
const AdvicePoint* advise_pick(const Advice* advice, double error, double ms,
                               const AdvicePoint** best);

/// The points that no other one beats in both, from the cheapest to the closest, into front
/// [count]; returns how many.
int advise_front(const Advice* advice, const AdvicePoint** front);

/// What makes a scene the point's.
void advise_sets(const World* world, const AdvicePoint* point, Overrides* sets);

typedef struct AdviseOptions {
    const char* scene;
    const SceneSet* set;
    int set_count;
    double error; ///< asked for [1]; 0: not
    double ms;    ///< of a frame [ms]; 0: not asked for
    bool fresh;   ///< measure again
    bool report;  ///< print lines for programs: "set KEY=VALUE", "says SENTENCE", and what comes
                  ///< nearest where the request cannot be met
    const char* precision; ///< only points of this one; NULL: of any
    const char* out;       ///< file for the scene; NULL: standard output
} AdviseOptions;

/// Write the scene as advised, what is expected of it in its head. Where it cannot be had, the
/// fault says what the best is.
bool advise_run(const AdviseOptions* options, Fault* fault);

/// Whether the points of the scene are kept, so that advice takes no time.
bool advise_is_kept(const AdviseOptions* options);

/// The same for a scene that is about to be opened: its overrides, or those of what comes nearest.
bool advise_auto(const AdviseOptions* options, Overrides* sets, Fault* fault);

// --- within: measuring (advise_measure.c) and keeping (advise_cache.c) ---

bool advise_measure(const char* scene, const SceneSet* set, int set_count, Advice* advice,
                    Fault* fault);

/// What was kept of a scene that is about so many outputs. False where nothing is kept that fits: a
/// file that is damaged, of another machine or program, or that no measurement could have written is
/// ignored. text: the scene with nothing left to guess (scene_text).
bool advise_recall(const char* text, int outputs, Advice* advice);

/// Keep it where the system keeps caches; where that cannot be done, the reason is printed.
void advise_keep(const char* text, const Advice* advice);

#endif
