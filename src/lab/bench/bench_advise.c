/// Accuracy of `balloon advise`: advice is requested, for an error or a cost, for scenes with a
/// closed form whose parameters are 10 % above or below the measured ones; the promised error and
/// cost are compared with the true error and the measured cost.
#include <math.h>
#include <string.h>

#include "lab/advice/advise.h"
#include "lab/bench/bench.h"
#include "lab/run/report.h"
#include "lab/truth/truth.h"
#include "base/paths.h"

enum { SETS = 2, RUNS = 3 };

/// Allowed ratio of measured to promised cost. [1]
static const double cost_margin = 1.5;
/// Minimum share of requests whose promise was fulfilled, or that were refused. [1]
static const double satisfied_min = 0.95;

static const double requested_error[] = {0.05, 0.01, 0.002}; ///< [1]
static const double requested_ms[] = {1, 4, 16};             ///< [ms]

/// A scene with parameters scaled by a factor, and the true value of its first output.
typedef struct RequestScene {
    const char* scene;
    const char* key; ///< set to `value` times the factor
    double value;
    double (*truth)(double factor);
    const char* set[SETS]; ///< other keys, up to the first NULL
} RequestScene;

static double sphere_volume(double l) {
    return 4.0 / 3 * PI * pow(0.1 * l, 3);
}

static double gas(double factor) {
    const TruthBalloon balloon = truth_balloon_default();
    return truth_pressure(&balloon, truth_stretch_gas(&balloon, 2 * factor));
}

static double thick_gas(double factor) {
    TruthBalloon balloon = truth_balloon_default();
    balloon.thickness *= factor;
    return truth_pressure(&balloon, truth_stretch_gas(&balloon, 2));
}

static double pressure(double factor) {
    TruthBalloon balloon = truth_balloon_default();
    balloon.modulus *= factor;
    return sphere_volume(truth_stretch_pressure(&balloon, 0.85 * 1108.503372));
}

static double sudden(double factor) {
    const TruthBalloon balloon = truth_balloon_default();
    return sphere_volume(truth_sudden(&balloon, 800 * factor, 0.02).l);
}

static double tied(double factor) {
    return truth_tether(386, 1e-3 * factor, 25, 9.8);
}

static double cube(double factor) {
    TruthCube cube = truth_cube_default();
    cube.amount *= factor;
    const double side = 2 / sqrt(3) * (sqrt(3) + truth_cube_growth(&cube, 0.02));
    return side * side * side;
}

// clang-format off
static const RequestScene request_table[] = {
    {"sphere-gas",      "balloons.0.inflation.fill.to", 2, gas, {NULL}},
    {"sphere-gas",      "balloons.0.skin.membrane.thickness", 3e-4, thick_gas, {NULL}},
    {"sphere-pressure", "balloons.0.skin.membrane.young", 1e6, pressure,
                        {"balloons.0.inflation.fill.to=942.2278662"}},
    {"sphere-step",     "balloons.0.inflation.amount", 800, sudden, {NULL}},
    {"tether",          "balloons.0.mass.per_particle", 1e-3, tied, {"seconds=3",
                         "about=[{output: balloon0.string0.tension, at: 3, tolerance: 0.01}]"}},
    {"exact-cube",      "balloons.0.inflation.amount", 1, cube, {NULL}},
};
// clang-format on
enum { REQUESTS = sizeof request_table / sizeof *request_table };

typedef struct Tally {
    int requests, satisfied, refused;
} Tally;

static int sets_for(const RequestScene* request, double factor, Overrides* sets, SceneSet* set) {
    overrides_add(sets, "%s=%.17g", request->key, request->value * factor);
    for (int k = 0; k < SETS && request->set[k]; k++)
        overrides_add(sets, "%s", request->set[k]);
    for (int k = 0; k < sets->count; k++)
        set[k].text = sets->text[k];
    return sets->count;
}

/// Run the scene as advised: its first output, and the minimum cost of a frame over RUNS.
static bool run_advised(const char* scene, const World* world, const Overrides* sets, double* value,
                        double* ms, Fault* fault) {
    char program[512];
    const AboutDef* about = &world->def.about[0];
    if (!paths_sibling("balloon", program, fault))
        return false;
    *ms = INFINITY;
    bool good = true;
    for (int run = 0; good && run < RUNS; run++) {
        Launch launch = {.words = 0};
        Report report;
        launch_add(&launch, "%s", program);
        launch_add(&launch, "run");
        launch_add(&launch, "%s", scene);
        for (int k = 0; k < sets->count; k++)
            launch_add(&launch, "--set=%s", sets->text[k]);
        launch_add(&launch, "--seconds=%.17g", fmax(0.3, about->at));
        launch_add(&launch, "--report");
        good = launch_all(&launch, 1, 1, "advised", fault);
        if (good) {
            report_read(&report, &launch);
            *value = report_output(&report, 0);
            *ms = fmin(*ms, report.ms / ADVISE_FPS);
            report_free(&report);
        }
        launch_free(&launch);
    }
    return good;
}

static bool request_one(const RequestScene* request, double factor, const World* world,
                        const Advice* advice, const Overrides* own, double error, double ms,
                        Tally* tally, Fault* fault) {
    const AdvicePoint* best;
    const AdvicePoint* point = advise_pick(advice, error, ms, &best);
    tally->requests++;
    printf("%s,%g,%g,", request->scene, error, ms);
    if (!point) { // refused: nothing was promised
        tally->satisfied++;
        tally->refused++;
        puts("-,,,,,,,");
        return true;
    }
    Overrides sets = *own;
    double value, cost;
    advise_sets(world, point, &sets);
    if (!run_advised(request->scene, world, &sets, &value, &cost, fault))
        return false;
    const double truth = request->truth(factor), off = fabs(value - truth) / fabs(truth);
    const double promise = advise_promise(advice, point);
    fflush(stdout);
    tally->satisfied += off <= promise && cost <= cost_margin * point->ms;
    printf("%s,%d,%g,%s,%.3g,%.3g,%.3g,%.3g\n", point->method, point->refinement, point->step,
           point->precision, promise, off, point->ms, cost);
    return true;
}

static bool request_all(const RequestScene* request, double factor, bool quick, Tally* tally,
                        Fault* fault) {
    Overrides own = {.count = 0}, first = {.count = 0};
    SceneSet set[MAX_OVERRIDES], measured[MAX_OVERRIDES];
    Advice advice;
    WorldDef def;
    World world;
    const int count = sets_for(request, factor, &own, set);
    sets_for(request, 1, &first, measured);
    if (!advise_points(request->scene, measured, count, false, &advice, fault))
        return false;
    bool good =
        scene_load(request->scene, set, count, &def, fault) && world_open(&world, &def, fault);
    if (!good) {
        advise_free(&advice);
        return false;
    }
    for (int k = 0; good && k < 3; k++)
        good = request_one(request, factor, &world, &advice, &own, requested_error[k], 0, tally,
                           fault);
    for (int k = 0; good && !quick && k < 3; k++)
        good =
            request_one(request, factor, &world, &advice, &own, 0, requested_ms[k], tally, fault);
    world_close(&world);
    advise_free(&advice);
    return good;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    const bool quick = options->quick;
    Tally tally = {0};
    puts("scene,asked_error,asked_ms,method,level,step,precision,expected_error,measured_error,"
         "expected_ms,measured_ms");
    for (int k = 0; k < REQUESTS; k++) {
        if (quick && k + 1 < REQUESTS)
            continue;
        if (!request_all(&request_table[k], 0.9, quick, &tally, fault) ||
            !request_all(&request_table[k], 1.1, quick, &tally, fault))
            return false;
    }
    printf("%d of %d requests satisfied, %d of them by a refusal\n", tally.satisfied,
           tally.requests, tally.refused);
    return tally.satisfied >= satisfied_min * tally.requests ||
           fault_set(fault, "advise", "%d of %d requests were satisfied, which is less than %g %%",
                     tally.satisfied, tally.requests, 100 * satisfied_min);
}

const BenchCase bench_advise = {
    .name = "advise",
    .about = "promised against true errors and costs of advice, on closed forms",
    .run = measure,
};
