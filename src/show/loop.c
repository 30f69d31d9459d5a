/// The main loop: input, steps that are due, picture, output.
#include "show/app.h"

#include <math.h>
#include <string.h>

#include "base/interrupt.h"
#include "hud/hud.h"
#include "show/keys.h"
#include "view/status.h"

// In a window, measuring the map may take this wall time of a frame [ms], or this share of the
// frame if that is more.
static const double MAP_MS = 8, MAP_SHARE = 0.25;
// Headless, the map gets this many parts per frame, so that films do not depend on the time.
static const double MAP_PARTS = 400;

static void move_camera(Camera* camera, const Input* input) {
    camera_orbit(camera, input->orbit[0], input->orbit[1]);
    camera_pan(camera, input->pan[0], input->pan[1]);
    camera_zoom(camera, input->zoom);
}

static bool handle_key(App* app, const KeyEvent* event, Fault* fault) {
    const int row = command_key_find(event->name);
    if (row >= 0)
        return session_key(&app->session, row, event->down, fault);
    const ViewKey* key = view_key_find(event->name);
    memcpy(app->pointer, event->pointer, sizeof app->pointer);
    if (key && event->down)
        key->down(app);
    return true;
}

static bool handle_input(App* app, const Input* input, Fault* fault) {
    move_camera(&app->camera, input);
    for (int k = 0; k < input->key_count; k++)
        if (!handle_key(app, &input->key[k], fault))
            return false;
    app->message_seconds -= input->elapsed;
    return true;
}

/// Print the world's notice, if there is one, in the overlay and in the terminal.
static void repeat_notice(App* app) {
    char* notice = app->world->notice;
    if (!notice[0])
        return;
    app_say(app, "%s", notice);
    if (!app->options->quiet)
        fprintf(stderr, "balloon: %s\n", notice);
    notice[0] = 0;
}

/// Steps from one picture to the next, at the present speed.
static long steps_per_frame(const App* app) {
    const double steps = 1 / (app->options->fps * app->pacer.slowdown * app->world->step);
    return steps > 1 ? lround(steps) : 1;
}

/// CPU time of the ghost's steps, to be excluded from the cost of the scene's. [ms]
static double ghost_ms(const App* app) {
    return app->session.ghost ? 1e3 * app->session.ghost->ghost_spent : 0;
}

static bool advance(App* app, double elapsed, Fault* fault) {
    long due = pacer_due(&app->pacer, elapsed);
    if (app->lab)
        live_lab_start(app->lab, app->world);
    for (; due > 0 && app->world->clock < app->end_step && !app->output.late(app->output.self) &&
           !interrupt_signal();
         due--) {
        const double before = ghost_ms(app);
        if (!session_step(&app->session, fault))
            return false;
        if (app->lab)
            live_lab_step(app->lab, app->world, steps_per_frame(app), ghost_ms(app) - before);
    }
    repeat_notice(app);
    return true;
}

/// The renderer's size and the overlay's scale follow the window.
static bool match_output(App* app, const Input* input, Fault* fault) {
    if (input->width != app->width || input->height != app->height)
        renderer_resize(app->renderer, input->width, input->height);
    app->width = input->width;
    app->height = input->height;

    if (input->scale == app->overlay_scale)
        return true;
    if (app->overlay_scale > 0)
        hud_close();
    app->overlay_scale = hud_open(input->scale, fault) ? input->scale : 0;
    return app->overlay_scale > 0;
}

static void draw(App* app, double elapsed, double frame_ms) {
    picture_update(&app->picture, app->world, &app->camera, app->mode);
    stages_end(&app->stages, STAGE_PICTURE);
    renderer_draw(app->renderer, &app->picture);
    stages_drawn(&app->stages, renderer_times(app->renderer));

    char compared[200] = "";
    if (app->session.ghost)
        ghost_summary(app->session.ghost, app->world, compared, sizeof compared);
    const Status status = {
        .mode = app->mode,
        .thrower = app->output.full_screen ? &app->thrower : NULL, // headless: no user
        .slowdown = app->pacer.slowdown,
        .paused = app->pacer.paused,
        .compared = compared,
        .frame_ms = frame_ms,
        .message = app->overlay.status_visible && app->message_seconds > 0 ? app->message : "",
    };
    status_fill(&app->overlay, app->world, &app->picture, &status);
    app->overlay.lab_panel = NULL;
    if (app->lab) {
        // a window must stay fluent; a film must not depend on the time
        const bool user = app->output.full_screen;
        live_lab_work(app->lab, user ? INFINITY : MAP_PARTS * elapsed * app->options->fps,
                      user ? fmax(MAP_MS, 1e3 * MAP_SHARE * elapsed) : INFINITY);
        app->overlay.lab_panel = live_lab_update(app->lab, app->world, app->watching, app->notch);
    }
    renderer_bind_resolved(app->renderer);
    hud_draw(&app->overlay, app->width, app->height);
    stages_end(&app->stages, STAGE_OVERLAY);
}

bool app_run(App* app, Fault* fault) {
    Input input;
    while (!app->quit && app->world->clock < app->end_step && !interrupt_signal() &&
           app->output.next(app->output.self, &input)) {
        stages_begin(&app->stages);
        app_follow_advice(app);
        if (!handle_input(app, &input, fault) || !advance(app, input.elapsed, fault) ||
            !match_output(app, &input, fault))
            return false;
        stages_end(&app->stages, STAGE_STEPS);

        draw(app, input.elapsed, input.frame_ms);
        if (!app->output.present(app->output.self, app->renderer, fault))
            return false;
        stages_end(&app->stages, STAGE_PRESENT);
        if (app->screenshot)
            app_screenshot(app);
    }
    if (app->options->stages)
        *app->options->stages = app->stages;
    if (app->options->time)
        stages_print(&app->stages);
    if (app_display_lost(app, fault))
        return false;
    return !interrupt_signal() ||
           interrupt_fault(app->world->def.file, world_time(app->world), fault);
}
