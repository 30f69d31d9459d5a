/// Wall time of the stages of a headless frame of 1280 x 720, over the last frames of two simulated
/// seconds. Pictures are read back but not written.
#include "show/bench_frame.h"

#include <stdio.h>

#include "show/show.h"

static const char* const scene_table[] = {"party", "crowd", "teddy"};
enum { SCENES = sizeof scene_table / sizeof *scene_table };

/// Simulated time of a full and of a quick run. [s]
static const double seconds_table[] = {2, 0.05};

static bool run_scene(const char* scene, const BenchOptions* options, Fault* fault) {
    WorldDef def;
    World world;
    Stages stages = {.frames = 0};
    ShowOptions show = show_options_default();
    show.seconds = seconds_table[options->quick];
    show.stages = &stages;
    show.quiet = true;
    if (!scene_load(scene, NULL, 0, &def, fault) || !world_open(&world, &def, fault))
        return false;
    int particles = 0;
    for (int b = 0; b < world.balloon_count; b++)
        particles += world.balloon[b].body.count;
    const bool good = show_render(&world, &show, fault);
    world_close(&world);
    if (!good)
        return false;
    const int sample_count = stages.frames < RECENT_FRAMES ? (int)stages.frames : RECENT_FRAMES;
    double sample[RECENT_FRAMES];
    for (int stage = 0; stage < STAGES; stage++) {
        for (int k = 0; k < sample_count; k++)
            sample[k] = stages.recent[(stages.frames - k) % RECENT_FRAMES][stage];
        figures_add_samples(options->figures, scene, particles, stage_name[stage], "ms/frame",
                            sample, sample_count);
    }
    return true;
}

static bool measure_scenes(const BenchOptions* options, Fault* fault) {
    figures_head(options->figures);
    for (int k = 0; k < SCENES; k++)
        if (!run_scene(scene_table[k], options, fault))
            return false;
    return true;
}

const BenchCase bench_frame = {
    .name = "frame",
    .about = "wall time of a frame, stage by stage",
    .timed = true,
    .run = measure_scenes,
};
