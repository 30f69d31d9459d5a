/// The thin-shell paper's Table 1, reproduced with other models of similar shapes and sizes: skins
/// of 0.3 mm, E = 1 MPa, nu = 0.45, steps of 1/60 s, the gas rises from one to two times its
/// initial amount within 300 frames, p0 V0/V without the atmosphere. Once with the paper's effort,
/// three Newton iterations with conjugate gradients to 1e-3, once with the step's equation solved
/// to 1e-6. Source: the thin-shell balloon paper, Table 1, on one core of an i7 of 3.4 GHz.
///
/// Applying p0 suddenly at rest would buckle a skin with folds permanently. So the gas first rises
/// from zero to its initial amount in the same number of frames, which are not counted.
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "body/membrane.h"
#include "lab/bench/bench.h"
#include "world/world.h"

static const struct {
    const char* model;
    double paper; ///< [ms a frame]
} row_table[] = {
    {"teddy.obj", 278.0}, {"bird.obj", 187.2},          {"holes.obj", 207.6},
    {"vase.obj", 522.6},  {"cube-cylinder.obj", 484.2},
};

static const struct {
    const char* about;
    const char* metric;
    const char* solver;
} effort_table[] = {
    {"three Newton iterations, conjugate gradients to 1e-3", "3 iterations",
     "solver={iterations: 3, fixed: true, linear_tolerance: 1e-3}"},
    {"the step's equation to 1e-6", "to 1e-6", "solver={tolerance: 1e-6}"},
};

enum {
    ROWS = sizeof row_table / sizeof *row_table,
    EFFORTS = sizeof effort_table / sizeof *effort_table,
    FRAMES = 300,
    FRAMES_QUICK = 60
};

/// The paper's setting: overrides of the scene.
static const char* const setting[] = {
    "step=0.016666666666666666", "gravity=0", "method=newton", "balloons.0.size=0.2",
    ("balloons.0.skin={membrane: {material: stvk-3d, young: 1e6, poisson: 0.45, density: 1000, "
     "thickness: 3e-4, volume: global}}")};
enum { SETTINGS = sizeof setting / sizeof *setting, SETS = SETTINGS + 3 };

/// Results over the counted frames of one model.
typedef struct Sum {
    int frames;        ///< 0 after a blowup
    double ms[FRAMES]; ///< time of each [ms]
    long iterations, products;
    double volume; ///< the total rubber's volume ratio farthest from 1
    double worst;  ///< an element's volume ratio farthest from 1
} Sum;

static double farther(double a, double b) {
    return fabs(a - 1) > fabs(b - 1) ? a : b;
}

static void play(World* world, int frames, Sum* sum) {
    const Balloon* balloon = &world->balloon[0];
    *sum = (Sum){.volume = 1, .worst = 1};
    for (int frame = 0; frame < frames; frame++)
        world_step(world);
    for (; sum->frames < frames && !world->blowup.halted; sum->frames++) {
        const double start = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
        world_step(world);
        sum->ms[sum->frames] = 1e3 * (clock_seconds(CLOCK_THREAD_CPUTIME_ID) - start);
        sum->iterations += balloon->stats.iterations;
        sum->products += balloon->stats.products;
        const VolumeRatio ratio = membrane_volume_ratio(&balloon->body.membrane, balloon->body.x);
        sum->volume = farther(ratio.sum, sum->volume);
        sum->worst = farther(ratio.worst, sum->worst);
    }
}

/// Results of one model, for the final table.
typedef struct Row {
    int particles;
    Sum sum;
} Row;

static bool run_row(int row, int effort, int frames, Row* done, Fault* fault) {
    char model[64], inflation[160];
    snprintf(model, sizeof model, "balloons.0.model=%s", row_table[row].model);
    snprintf(inflation, sizeof inflation,
             "balloons.0.inflation={law: gas, amount: 0, ambient: 0, unit: 2000, max: 2, "
             "fill: {to: 2, seconds: %.17g}}",
             2 * frames / 60.0);
    SceneSet set[SETS] = {{model}, {effort_table[effort].solver}, {inflation}};
    for (int k = 0; k < SETTINGS; k++)
        set[3 + k].text = setting[k];
    WorldDef def;
    World world;
    if (!scene_load("teddy", set, SETS, &def, fault) || !world_open(&world, &def, fault))
        return false;
    const Body* body = &world.balloon[0].body;
    Sum* sum = &done->sum;
    done->particles = body->count;
    play(&world, frames, sum);
    if (world.blowup.halted) { // the times are meaningless
        printf("%-18s %8d %8d %s\n", row_table[row].model, body->count, body->membrane.count,
               world.blowup.text);
        sum->frames = 0;
    } else {
        double ms = 0;
        for (int frame = 0; frame < frames; frame++)
            ms += sum->ms[frame] / frames;
        printf("%-18s %8d %8d %7d %9.1f %9.1f %7.1f %7.1f %9.1f %+14.2e %8.4f\n",
               row_table[row].model, body->count, body->membrane.count, frames, ms,
               row_table[row].paper, row_table[row].paper / ms, (double)sum->iterations / frames,
               (double)sum->products / frames, sum->volume - 1, sum->worst);
    }
    fflush(stdout);
    world_close(&world);
    return true;
}

static bool measure(const BenchOptions* options, Fault* fault) {
    static Row done[EFFORTS][ROWS];
    for (int effort = 0; effort < EFFORTS; effort++) {
        printf("%s\n%-18s %8s %8s %7s %9s %9s %7s %7s %9s %14s %8s\n", effort_table[effort].about,
               "model", "vertices", "elements", "frames", "ms/frame", "paper's", "times", "Newton",
               "products", "rubber - 1", "worst");
        for (int row = 0; row < ROWS; row++)
            if ((!options->only || strstr(row_table[row].model, options->only)) &&
                !run_row(row, effort, options->quick ? FRAMES_QUICK : FRAMES, &done[effort][row],
                         fault))
                return false;
    }
    figures_head(options->figures);
    for (int effort = 0; effort < EFFORTS; effort++)
        for (int row = 0; row < ROWS; row++) {
            Row* one = &done[effort][row];
            if (one->sum.frames > 0)
                figures_add_samples(options->figures, row_table[row].model, one->particles,
                                    effort_table[effort].metric, "ms/frame", one->sum.ms,
                                    one->sum.frames);
        }
    return true;
}

const BenchCase bench_table1 = {
    .name = "table1",
    .about = "the thin-shell paper's Table 1: ms a frame for five skins of rubber",
    .timed = true,
    .run = measure,
};
