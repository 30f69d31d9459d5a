#include "show/stages.h"

#include <stdio.h>
#include <string.h>

#include "base/clock.h"

const char* const stage_name[STAGES] = {"steps", "picture", "upload",  "shadow",
                                        "scene", "resolve", "overlay", "present"};

double stages_now(void) {
    return 1e3 * clock_seconds(CLOCK_MONOTONIC);
}

void stages_begin(Stages* stages) {
    stages->stage_start = stages_now();
    stages->frames++;
    memset(stages->recent[stages->frames % RECENT_FRAMES], 0, sizeof *stages->recent);
}

static void add(Stages* stages, Stage stage, double ms) {
    stages->ms[stage] += ms;
    stages->recent[stages->frames % RECENT_FRAMES][stage] += ms;
}

void stages_end(Stages* stages, Stage stage) {
    const double end = stages_now();
    add(stages, stage, end - stages->stage_start);
    stages->stage_start = end;
}

void stages_drawn(Stages* stages, RendererTimes times) {
    add(stages, STAGE_UPLOAD, times.upload);
    add(stages, STAGE_SHADOW, times.shadow);
    add(stages, STAGE_SCENE, times.scene);
    add(stages, STAGE_RESOLVE, times.resolve);
    stages->stage_start = stages_now();
}

void stages_print(const Stages* stages) {
    double all = 0;
    if (stages->frames == 0)
        return;
    printf("%ld frames; of a frame [ms]:", stages->frames);
    for (int k = 0; k < STAGES; k++) {
        const double ms = stages->ms[k] / (double)stages->frames;
        printf(" %s %.3f", stage_name[k], ms);
        all += ms;
    }
    printf("; in all %.3f\n", all);
}
