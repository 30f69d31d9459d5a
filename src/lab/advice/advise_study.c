#include "lab/advice/advise_study.h"

#include <math.h>

#include "base/clock.h"
#include "base/paths.h"
#include "lab/run/refinement.h"

const double ADVISE_SECONDS_MAX = 120, ADVISE_COST_MAX = 1500;

/// Minimum wall time of a run, because a launch reads 0 as no limit. [s]
static const double min_wall = 0.1;

double study_time_remaining(const Study* study, double share) {
    const double used = clock_seconds(CLOCK_MONOTONIC) - study->start;
    return fmax(share * ADVISE_SECONDS_MAX - used, 0);
}

AdvicePoint advise_point(const char* method, const char* precision, int refinement, double step) {
    AdvicePoint point = {.refinement = refinement, .step = step};
    snprintf(point.method, sizeof point.method, "%s", method);
    snprintf(point.precision, sizeof point.precision, "%s", precision);
    return point;
}

static bool command(const Study* study, const AdvicePoint* point, double seconds, Launch* launch,
                    Fault* fault) {
    char program[512];
    if (!paths_sibling("balloon", program, fault))
        return false;
    Overrides sets = {.count = 0};
    advise_sets(&study->world, point, &sets);
    launch_add(launch, "%s", program);
    launch_add(launch, "run");
    launch_add(launch, "%s", study->scene);
    for (int k = 0; k < study->set_count; k++)
        launch_add(launch, "--set=%s", study->set[k].text);
    for (int k = 0; k < sets.count; k++)
        launch_add(launch, "--set=%s", sets.text[k]);
    launch_add(launch, "--seconds=%.17g", seconds);
    launch_add(launch, "--report");
    return true;
}

bool study_run(const Study* study, const AdvicePoint* point, double seconds, double cpu_max,
               double wall_max, double value[], Report* report, Fault* fault) {
    Launch launch = {.cpu_max = cpu_max, .wall_max = fmax(wall_max, min_wall)};
    const bool good =
        command(study, point, seconds, &launch, fault) && launch_all(&launch, 1, 1, NULL, fault);
    if (good) {
        report_read(report, &launch);
        for (unsigned k = 0; k < study->outputs; k++)
            value[k] = report_output(report, k);
    }
    launch_free(&launch);
    return good;
}

int study_points_at(const Study* study, int refinement) {
    Overrides sets = {.count = 0};
    if (refinement != 0 && !refinement_add(&study->world, refinement, &sets))
        return 0;
    SceneSet set[MAX_OVERRIDES * 2];
    int count = 0, points = 0;
    for (int k = 0; k < study->set_count; k++)
        set[count++] = study->set[k];
    for (int k = 0; k < sets.count; k++)
        set[count++].text = sets.text[k];
    WorldDef def;
    World world;
    Fault unused = {0};
    if (!scene_load(study->scene, set, count, &def, &unused) || !world_open(&world, &def, &unused))
        return 0;
    for (int b = 0; b < world.balloon_count; b++)
        points += world.balloon[b].body.count;
    world_close(&world);
    return points;
}
