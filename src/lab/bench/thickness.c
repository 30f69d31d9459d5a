/// Figure 7 of the thin-shell paper, measured: a teddy with skins of 0.3, 0.2 and 0.1 mm and the
/// same gas, p0 V0/V without the atmosphere. The height of the ears above the crown of the head
/// measures how far they have merged into it; volume and height are relative to the initial ones.
#include <stdio.h>

#include "lab/bench/bench.h"
#include "world/probe.h"
#include "world/world.h"

enum { SKINS = 3, FRAMES = 300 };

static const double ear_aside = 0.15;   ///< an ear is farther from the middle plane [of the width]
static const double crown_aside = 0.02; ///< the crown is nearer to it [of the width]

/// The highest particle of the rest shape beyond, or within, a distance from its middle plane.
static int highest(const Mesh* mesh, double aside, bool beyond) {
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < mesh->point_count; i++) {
        low = fmin(low, mesh->point[i][0]);
        high = fmax(high, mesh->point[i][0]);
    }
    int best = NONE;
    for (int i = 0; i < mesh->point_count; i++) {
        const double away = fabs(mesh->point[i][0] - (low + high) / 2) / (high - low);
        if ((away > aside) == beyond && (best == NONE || mesh->point[i][1] > mesh->point[best][1]))
            best = i;
    }
    return best;
}

/// Measurements of a balloon: volume over the initial one [1], lengths [m].
typedef struct Look {
    double volume, height, ears;
} Look;

static Look look_at(const World* world, int b) {
    const Balloon* balloon = &world->balloon[b];
    const real4* x = balloon->body.x;
    char volume[32], height[32];
    snprintf(volume, sizeof volume, "balloon%d.volume", b);
    snprintf(height, sizeof height, "balloon%d.height", b);
    const int ear = highest(&balloon->mesh, ear_aside, true);
    const int crown = highest(&balloon->mesh, crown_aside, false);
    Look look = {.ears = (double)(x[ear][1] - x[crown][1])};
    probe_value(world, volume, &look.volume);
    probe_value(world, height, &look.height);
    return look;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    const bool quick = options->quick;
    const SceneSet set[SKINS] = {{"balloons.0.model=teddy.obj"},
                                 {"balloons.1.model=teddy.obj"},
                                 {"balloons.2.model=teddy.obj"}};
    WorldDef def;
    World world;
    if (!scene_load("thickness", set, SKINS, &def, fault) || !world_open(&world, &def, fault))
        return false;
    Look first[SKINS];
    for (int b = 0; b < SKINS; b++)
        first[b] = look_at(&world, b);
    for (int frame = 0; frame < (quick ? FRAMES / 10 : FRAMES); frame++)
        world_step(&world);

    printf("%9s %8s %8s %22s %10s\n", "skin [mm]", "volume", "height", "ears over crown [mm]",
           "of height");
    for (int b = 0; b < SKINS; b++) {
        const Look last = look_at(&world, b);
        printf("%9.1f %8.3f %8.3f %13.2f -> %5.2f %10.4f\n",
               1e3 * (double)world.balloon[b].body.membrane.first[0], last.volume / first[b].volume,
               last.height / first[b].height, 1e3 * first[b].ears, 1e3 * last.ears,
               last.ears / last.height);
    }
    const bool good = !world.blowup.halted;
    if (!good)
        fault_set(fault, NULL, "%s", world.blowup.text);
    world_close(&world);
    return good;
}

const BenchCase bench_thickness = {
    .name = "thickness",
    .about = "the thin-shell paper's figure 7: skins of 0.3, 0.2 and 0.1 mm with the same gas",
    .run = measure,
};
