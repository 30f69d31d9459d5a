#include "show/slider.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "show/pacer.h"
#include "world/probe.h"

void slider_open(Slider* slider, const World* world, const SceneSet* set, int set_count) {
    Fault unused = {0};
    *slider = (Slider){.error = (double)NAN};
    char* text = scene_text(world->def.file, set, set_count, false, &unused);
    if (text && advise_cache_read(text, (int)scene_outputs(&world->def), &slider->advice)) {
        slider->front = new_array(const AdvicePoint*, slider->advice.count);
        const int count = advise_front(&slider->advice, slider->front);
        const char* own = sizeof(real) == sizeof(double) ? "double" : "float";
        for (int k = 0; k < count && slider->notches < LAB_NOTCHES; k++)
            if (strcmp(slider->front[k]->precision, own) == 0)
                slider->front[slider->notches++] = slider->front[k];
    }
    free(text);
}

void slider_begin(Slider* slider) {
    slider->error = (double)NAN;
    slider->spent = 0;
}

void slider_step(Slider* slider, const World* world, double ms) {
    const Advice* advice = &slider->advice;
    slider->spent += ms;
    for (int k = 0; k < advice->outputs && k < (int)scene_outputs(&world->def); k++) {
        double value;
        const double truth = advice->reference[k];
        if (pacer_steps(world->def.about[k].at, world->step) == world->step_count &&
            probe_value(world, world->def.about[k].output, &value))
            slider->error = fmax(slider->error, fabs(value - truth) / fabs(truth));
    }
}

void slider_sets(const Slider* slider, const World* original, int notch, Overrides* sets) {
    advise_sets(original, slider->front[notch - 1], sets);
}

__attribute__((format(printf, 2, 3))) static void say(LabSlider* panel, const char* format, ...) {
    va_list list;
    va_start(list, format);
    vsnprintf(panel->line[panel->lines++], sizeof panel->line[0], format, list);
    va_end(list);
}

void slider_fill(const Slider* slider, const World* world, int notch, bool timed,
                 LabSlider* panel) {
    panel->notches = slider->notches;
    panel->notch = notch;
    panel->lines = 0;
    if (slider->notches == 0) {
        say(panel, "not measured here yet:");
        say(panel, "balloon advise SCENE --budget 4ms");
        return;
    }
    say(panel, "%s, step %.3g ms, %d points", world->method->name, 1e3 * world->step,
        world->balloon[0].body.count);
    if (notch > 0) {
        const AdvicePoint* point = slider->front[notch - 1];
        say(panel, "expected: %.2g %% off, %.2g ms a frame",
            100 * advise_promise(&slider->advice, point), point->ms);
    } else {
        say(panel, "the scene as it is");
    }
    char off[32] = "not yet known", cost[32] = "";
    if (isfinite(slider->error))
        snprintf(off, sizeof off, "%.2g %% off", 100 * slider->error);
    if (timed && world->step_count > 0)
        snprintf(cost, sizeof cost, ", %.2g ms a frame",
                 slider->spent / (world_time(world) * ADVISE_FPS));
    say(panel, "measured: %s%s", off, cost);
}

void slider_close(Slider* slider) {
    advise_free(&slider->advice);
    free(slider->front);
    *slider = (Slider){0};
}
