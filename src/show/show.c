#include "show/show.h"

#include <limits.h>
#include <math.h>

#include "base/interrupt.h"
#include "show/app.h"

// Pacer.frame_max of a window: after an interruption the simulation continues without a jump. [s]
static const double MAX_WINDOW_FRAME = 1.0 / 20;

ShowOptions show_options_default(void) {
    return (ShowOptions){.width = 1280, .height = 720, .fps = 60, .overlay = true};
}

bool show_play(World* world, const ShowOptions* options, Fault* fault) {
    App app = {.options = options,
               .pacer = {.slowdown = 1, .frame_max = MAX_WINDOW_FRAME},
               .end_step = LONG_MAX};
    if (options->seconds > 0)
        app.end_step = pacer_steps(options->seconds, world->step);
    if (!app_begin(&app, world, fault))
        return false;
    if (!output_window(&app.output, "balloon", options->width, options->height, fault)) {
        session_close(&app.session, fault);
        return false;
    }

    if (options->advice)
        app_say(&app, "what is best here is being measured; then the scene starts again");
    else
        app_say(&app, "h shows the keys");
    const bool good = app_open(&app, fault) && app_run(&app, fault);

    // no fault: the user has seen the blowup, and could have reset the scene
    if (world->blowup.halted && !options->quiet)
        fprintf(stderr, "balloon: %s\n", world->blowup.text);
    return app_close(&app, good, fault);
}

/// Steps between the last frame and the end.
static bool finish(App* app, double seconds, Fault* fault) {
    while (app->world->clock < pacer_steps(seconds, app->world->step))
        if (interrupt_signal())
            return interrupt_fault(app->world->def.file, world_time(app->world), fault);
        else if (!session_step(&app->session, fault))
            return false;
    return true;
}

bool show_render(World* world, const ShowOptions* options, Fault* fault) {
    App app = {
        .options = options, .pacer = {.slowdown = 1, .frame_max = INFINITY}, .end_step = LONG_MAX};
    const FramesDef frames = {
        .out = options->out,
        .width = options->width,
        .height = options->height,
        .fps = options->fps,
        .seconds = options->seconds,
        .quiet = options->quiet,
    };
    if (!app_begin(&app, world, fault))
        return false;
    if (!output_frames(&app.output, &frames, fault)) {
        session_close(&app.session, fault);
        return false;
    }

    bool good =
        app_open(&app, fault) && app_run(&app, fault) && finish(&app, options->seconds, fault);
    good = app_close(&app, good, fault);

    // the frames up to the blowup stay
    if (world->blowup.halted)
        return fault_set(fault, world->def.file, "%s", world->blowup.text);
    return good;
}
