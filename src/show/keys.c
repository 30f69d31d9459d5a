#include "show/keys.h"

#include <string.h>

#include "hud/hud.h"
#include "show/app.h"
#include "view/framing.h"
#include "world/command.h"

static void run_or_pause(App* app) {
    app->pacer.paused = !app->pacer.paused;
}

static void single_step(App* app) {
    app->pacer.paused = true;
    app->pacer.single++;
}

static void slower(App* app) {
    pacer_slower(&app->pacer);
}

static void faster(App* app) {
    pacer_faster(&app->pacer);
}

static void next_mode(App* app) {
    app->mode = mode_after(app->mode, app->world);
    app_say(app, "%s: %s", app->mode->name, app->mode->about);
}

static void next_scene(App* app) {
    app_next_scene(app, 1);
}

static void previous_scene(App* app) {
    app_next_scene(app, -1);
}

static void frame_all(App* app) {
    const Camera before = app->camera;
    app->camera = framing_all(app->world);
    app->camera.yaw = before.yaw;
    app->camera.pitch = before.pitch;
}

static void throw_ball(App* app) {
    double thrown[THROW_NUMBERS];
    const float aspect = (float)app->width / (float)app->height;
    Fault fault = {0};
    if (!thrower_throw(&app->thrower, app->world, &app->camera, aspect, app->pointer, thrown))
        app_say(app, "there is no room for a ball here");
    else if (!session_throw(&app->session, thrown, &fault))
        app_say(app, "%s: %s", fault.location, fault.text);
}

static void next_mass(App* app) {
    thrower_next_mass(&app->thrower);
    app_say(app, "the next ball's mass is %g", app->thrower.mass);
}

static void next_radius(App* app) {
    thrower_next_radius(&app->thrower);
    app_say(app, "the next ball's radius is %g", app->thrower.radius);
}

static void next_speed(App* app) {
    thrower_next_speed(&app->thrower);
    app_say(app, "the next ball's speed is %g", app->thrower.speed);
}

static void toggle_overlay(App* app) {
    app->overlay.status_visible = !app->overlay.status_visible;
}

static void toggle_help(App* app) {
    app->overlay.help_visible = !app->overlay.help_visible;
}

static void toggle_lab(App* app) {
    app_show_lab(app, !app->lab);
}

static void move_choice(App* app, int up, int right) {
    if (!app->lab)
        return;
    const int* chosen = app->lab->panel.map.chosen;
    live_lab_choose(app->lab, chosen[0] + up, chosen[1] + right);
}

static void stiffer(App* app) {
    move_choice(app, 1, 0);
}

static void softer(App* app) {
    move_choice(app, -1, 0);
}

static void shorter(App* app) {
    move_choice(app, 0, -1);
}

static void longer(App* app) {
    move_choice(app, 0, 1);
}

static void choose_at_pointer(App* app) {
    int cell[2];
    const int notch = hud_notch(&app->overlay, app->width, app->height, app->pointer);
    if (app->lab && notch > 0)
        app_select_notch(app, notch);
    if (notch > 0 || !app->lab ||
        !hud_cell(&app->overlay, app->width, app->height, app->pointer, cell))
        return;
    live_lab_choose(app->lab, cell[0], cell[1]);
    app_watch_cell(app);
}

static void less_accurate(App* app) {
    app_select_notch(app, app->notch - 1);
}

static void more_accurate(App* app) {
    app_select_notch(app, app->notch + 1);
}

static void full_screen(App* app) {
    if (app->output.full_screen)
        app->output.full_screen(app->output.self);
}

static void screenshot(App* app) {
    app->screenshot = true;
}

static void quit(App* app) {
    app->quit = true;
}

// clang-format off
const ViewKey view_key_table[] = {
    {"space",      "run or pause",                             run_or_pause},
    {".",          "pause and make a single step",             single_step},
    {"left",       "slower: 1/2, 1/4, 1/8, 1/16",              slower},
    {"right",      "faster, up to real time",                  faster},
    {"m",          "next display mode",                        next_mode},
    {"page down",  "next scene",                               next_scene},
    {"page up",    "previous scene",                           previous_scene},
    {"f",          "bring everything into sight",              frame_all},
    {"b",          "throw a ball at the pointer",              throw_ball},
    {"ctrl+click", "throw a ball there too",                   throw_ball},
    {"w",          "weight of the next ball: 0.1 to 1000",     next_mass},
    {"z",          "size of the next ball: radius 0.05 to 0.8", next_radius},
    {"s",          "speed of the next ball: 1 to 200",         next_speed},
    {"o",          "show or hide the overlay",                 toggle_overlay},
    {"g",          "show or hide the lab: plots, curve, map, slider", toggle_lab},
    {"[",          "on the slider: a notch faster",            less_accurate},
    {"]",          "a notch more accurate",                    more_accurate},
    {"i",          "on the map: choose a stiffer skin",        stiffer},
    {"k",          "a softer one",                             softer},
    {"j",          "a shorter step",                           shorter},
    {"l",          "a longer one",                             longer},
    {"enter",      "watch the scene with these, unguarded",    app_watch_cell},
    {"click",      "choose on the map or slider, and watch that",        choose_at_pointer},
    {"backspace",  "bring the scene back as it was",           app_restore_scene},
    {"h",          "show or hide these keys",                  toggle_help},
    {"f11",        "full screen or window",                    full_screen},
    {"p",          "write a screenshot",                       screenshot},
    {"q",          "quit",                                     quit},
};
// clang-format on
const int view_key_count = sizeof view_key_table / sizeof *view_key_table;

const ViewKey* view_key_find(const char* key) {
    for (int k = 0; k < view_key_count; k++)
        if (strcmp(view_key_table[k].key, key) == 0)
            return &view_key_table[k];
    return NULL;
}

int command_key_find(const char* key) {
    for (int k = 0; k < command_count; k++)
        if (strcmp(command_table[k].key, key) == 0)
            return k;
    return -1;
}

int keys_count(void) {
    return command_count + view_key_count;
}

OverlayKey keys_row(int row) {
    if (row < command_count)
        return (OverlayKey){command_table[row].key, command_table[row].about};
    const ViewKey* key = &view_key_table[row - command_count];
    return (OverlayKey){key->key, key->about};
}

void keys_print(FILE* out) {
    for (int k = 0; k < keys_count(); k++)
        fprintf(out, "  %-11s %s\n", keys_row(k).key, keys_row(k).about);
}
