/// `balloon advise SCENE`: the cheapest setting for a maximum error, or the most accurate one for a
/// maximum cost, chosen from runs that are measured on this machine.
///
/// A point is one method x refinement x step x precision on the scene, with `guard: split`, run by
/// the program itself:
///
///     error   max over the outputs of |value - reference| / |reference|                      [1]
///     cost    CPU time of stepping for a frame of 1/60 s, minimum over the runs              [ms]
///     promise ADVISE_MARGIN error + floor                                                    [1]
///
/// The errors of step and mesh can cancel at one point by chance. So each of the two is estimated
/// alone from neighboring points, and a point's error is at least the larger estimate
/// (advise_cancel.c).
///
/// The reference is extrapolated from runs by the scene's own method: from two steps to step 0 by
/// order 1, and from two refinements to edge length 0 by order 2. The floor is a tenth of the
/// distance between the finest run and the reference, at least 1e-4.
///
/// Measured steps are 1/60 s and its halves, beginning with the first that the guard does not
/// split, and ending where the error no longer falls or a frame costs 25 ms; a run that must exceed
/// this cost is ended. After ADVISE_SECONDS_MAX the measurement ends with the points that it has.
///
/// Points are cached (XDG_CACHE_HOME or ~/.cache). They are valid for every scene with the same
/// text in which each number differs by at most a fifth, on the same machine and for the same
/// build.
#ifndef BALLOON_LAB_ADVICE_ADVISE_H
#define BALLOON_LAB_ADVICE_ADVISE_H

#include "lab/run/overrides.h"
#include "world/world.h"

/// A comment that identifies a scene written by advice.
#define ADVISE_MARK "# What was put in its place:"

enum { ADVISE_OUTPUTS = 16 }; ///< maximum number of outputs in a scene's list `about`

extern const double ADVISE_MARGIN; ///< promised error over measured error [1]
extern const double ADVISE_FPS;    ///< frames per simulated second, for the cost of a frame [1/s]

typedef struct AdvicePoint {
    char method[24];
    char precision[8];
    int refinement; ///< of the scene's mesh (lab/run/refinement.h)
    double step;    ///< [s]
    double error;   ///< measured [1]; INFINITY: the run did not reach its end
    double ms;      ///< CPU time of a frame [ms]
} AdvicePoint;

typedef struct Advice {
    AdvicePoint* point; ///< [count] owned
    int count;
    double floor; ///< uncertainty of the reference [1]
    int outputs;
    double reference[ADVISE_OUTPUTS]; ///< values of the measured scene's outputs
} Advice;

/// The points of a scene: from the cache, or measured now and then cached. `fresh`: do not read the
/// cache. A scene without outputs in its list `about` is a fault.
bool advise_points(const char* scene, const SceneSet* set, int set_count, bool fresh,
                   Advice* advice, Fault* fault);
void advise_free(Advice* advice);

/// The promised error of a point [1].
double advise_promise(const Advice* advice, const AdvicePoint* point);

/// The cheapest point that promises `error`, or if `error` is 0 the most accurate one that costs at
/// most `ms`. NULL: there is none. nearest: the point that comes nearest to the request, NULL if no
/// point is finite.
const AdvicePoint* advise_pick(const Advice* advice, double error, double ms,
                               const AdvicePoint** nearest);

/// The Pareto front of cost and error, from the cheapest point to the most accurate one, into front
/// [count]. Returns the number of its points.
int advise_front(const Advice* advice, const AdvicePoint** front);

/// Add the overrides that give a scene the settings of a point.
void advise_sets(const World* world, const AdvicePoint* point, Overrides* sets);

typedef struct AdviseOptions {
    const char* scene;
    const SceneSet* set;
    int set_count;
    double error; ///< requested maximum error [1]; 0: request `ms`
    double ms;    ///< requested maximum CPU time of a frame [ms]
    bool fresh;   ///< measure, even if the cache has the scene
    bool
        report; ///< print lines for programs, "set KEY=VALUE" and "says SENTENCE"; the nearest point
                ///< where none meets the request
    const char* precision; ///< only points of this precision; NULL: of both
    const char* out;       ///< file for the scene; NULL: standard output
} AdviseOptions;

/// Write the advised scene, with its promised error and cost in a comment at its head. If no point
/// meets the request, the fault names the nearest one.
bool advise_run(const AdviseOptions* options, Fault* fault);

/// Whether the cache has the points of the scene, so that advice takes no time.
bool advise_is_cached(const AdviseOptions* options);

/// Advice for a scene that is about to be opened: the overrides of the point, or of the nearest one
/// where none meets the request.
bool advise_auto(const AdviseOptions* options, Overrides* sets, Fault* fault);

// --- internal: measurement (advise_measure.c) and cache (advise_cache.c) ---

bool advise_measure(const char* scene, const SceneSet* set, int set_count, Advice* advice,
                    Fault* fault);

/// Read the advice of a scene with so many outputs from the cache. False if the cache has none: a
/// file is ignored if it is damaged, comes from another machine or program, or has values that no
/// measurement gives. text: the scene with all its keys (scene_text).
bool advise_cache_read(const char* text, int outputs, Advice* advice);

/// Write the advice to the cache; print the reason if that fails.
void advise_cache_write(const char* text, const Advice* advice);

#endif
