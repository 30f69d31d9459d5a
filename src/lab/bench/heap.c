/// How still a heap of balloons lies: the scene `heap` for ten minutes, or for half of one.
///
/// After 10 s its kinetic energy is held below 1e-6 of its highest, and no balloon's middle may creep
/// by more than 1e-3 of the balloon's size in ten minutes.
#include <stdio.h>

#include "base/interrupt.h"
#include "lab/bench/bench.h"
#include "world/probe.h"
#include "world/world.h"

enum { BALLOONS_MAX = 16 };

static const double settled = 10;              ///< [s]
static const double minutes = 10, quick = 0.5; ///< [min]
static const double rest = 1e-6, creep = 1e-3; ///< [1] of the highest energy; sizes in ten minutes
static const double look_seconds = 0.1;        ///< [s]

static double kinetic_of(const World* world) {
    double sum = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        char column[32];
        double value = 0;
        snprintf(column, sizeof column, "balloon%d.kinetic", b);
        probe_value(world, column, &value);
        sum += value;
    }
    return sum;
}

static void middles_of(const World* world, double4 middle[BALLOONS_MAX]) {
    for (int b = 0; b < world->balloon_count && b < BALLOONS_MAX; b++)
        for (int k = 0; k < 3; k++) {
            char column[32];
            double value = 0;
            snprintf(column, sizeof column, "balloon%d.c%c", b, 'x' + k);
            probe_value(world, column, &value);
            middle[b][k] = value;
        }
}

/// Farthest way of a balloon's middle. [of its size]
static double farthest(const World* world, const double4 from[BALLOONS_MAX]) {
    double4 now[BALLOONS_MAX] = {{0}};
    double most = 0;
    middles_of(world, now);
    for (int b = 0; b < world->balloon_count && b < BALLOONS_MAX; b++)
        most = fmax(most, dlength(now[b] - from[b]) / world->balloon[b].body.size);
    return most;
}

static void run_until(World* world, double until, double* highest) {
    while (world_time(world) < until - world->step / 2 && !world->blowup.halted &&
           !interrupt_signal()) {
        world_step(world);
        if (world->step_count % lround(look_seconds / world->step) == 0)
            *highest = fmax(*highest, kinetic_of(world));
    }
}

static bool measure(const BenchOptions* options, Fault* fault) {
    WorldDef def;
    World world;
    if (!scene_load("heap", NULL, 0, &def, fault) || !world_open(&world, &def, fault))
        return false;
    double highest = 0, share = 0, way = 0, crossings = 0, before_rest = 0;
    double4 from[BALLOONS_MAX] = {{0}};
    run_until(&world, settled, &highest);
    middles_of(&world, from);
    const double until = settled + 60 * (options->quick ? quick : minutes);
    printf("%8s %18s %18s %10s\n", "t [s]", "kinetic [highest]", "creep [sizes]", "crossings");
    for (double t = settled; t <= until && !world.blowup.halted && !interrupt_signal(); t += 30) {
        run_until(&world, t, &before_rest);
        share = fmax(share, kinetic_of(&world) / highest);
        way = farthest(&world, from);
        probe_value(&world, "crossings", &crossings);
        printf("%8.0f %18.2e %18.2e %10.0f\n", world_time(&world), kinetic_of(&world) / highest,
               way, crossings);
        fflush(stdout);
    }
    const bool good = !world.blowup.halted && share < rest && way < creep && crossings == 0;
    if (!good)
        fault_set(fault, NULL, "the heap does not rest: %s",
                  world.blowup.halted ? world.blowup.text : "see the table");
    world_close(&world);
    return good;
}

const BenchCase bench_heap = {
    .name = "heap",
    .about = "ten minutes of the scene heap at rest: kinetic energy, creep, crossings",
    .run = measure,
};
