#include "show/stages.h"

#include <stdio.h>

#include "base/clock.h"

static const char* const stage_name[STAGES] = {"steps", "picture", "upload",  "shadow",
                                               "scene", "resolve", "overlay", "present"};

double stages_now(void) {
    return 1e3 * clock_seconds(CLOCK_MONOTONIC);
}

void stages_begin(Stages* stages) {
    stages->since = stages_now();
    stages->frames++;
}

void stages_end(Stages* stages, Stage stage) {
    const double end = stages_now();
    stages->ms[stage] += end - stages->since;
    stages->since = end;
}

void stages_drawn(Stages* stages, RendererTimes times) {
    stages->ms[STAGE_UPLOAD] += times.upload;
    stages->ms[STAGE_SHADOW] += times.shadow;
    stages->ms[STAGE_SCENE] += times.scene;
    stages->ms[STAGE_RESOLVE] += times.resolve;
    stages->since = stages_now();
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
