#include "show/app.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "hud/hud.h"
#include "show/keys.h"
#include "show/film/png.h"
#include "view/framing.h"
#include "base/paths.h"

static const double MESSAGE_SECONDS = 5;
enum { MAX_SCREENSHOTS = 9999 };

void app_say(App* app, const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(app->message, sizeof app->message, format, arguments);
    va_end(arguments);
    app->message_seconds = MESSAGE_SECONDS;
}

/// The mode that a scene begins with, or NULL with a fault.
static const Mode* mode_of(const WorldDef* def, Fault* fault) {
    const Mode* mode = def->show ? mode_find(def->show) : &mode_skin;
    if (!mode)
        fault_set(fault, def->file, "show: no display mode '%s'; there are %s", def->show,
                  mode_names());
    return mode;
}

/// Reset camera, thrower, pacer and picture for the present world; the speed stays.
static void reset_view(App* app) {
    const Pacer before = app->pacer;
    app->pacer = pacer_make(app->world->step, before.frame_max);
    app->pacer.slowdown = before.slowdown;
    app->pacer.paused = before.paused;
    app->camera = framing_first(app->world);
    app->thrower = thrower_default(app->world, &app->camera);
    picture_open(&app->picture, app->world);
    if (app->session.ghost)
        picture_ghost(&app->picture, &app->session.ghost->world);
    if (app->lab)
        live_lab_begin(app->lab);
}

// ---- other scenes ----

/// A scene's identity in the list: its path below assets/scenes, or its file name elsewhere.
static const char* scene_id(const char* path) {
    const char* folder = strstr(path, "assets/scenes/");
    const char* slash = strrchr(path, '/');
    return folder ? folder : slash ? slash + 1 : path;
}

static int scene_index(char* const* path, int count, const char* file) {
    for (int k = 0; k < count; k++)
        if (strcmp(scene_id(path[k]), scene_id(file)) == 0)
            return k;
    return -1;
}

/// Open a ghost of the next scene. If its method refuses the scene, there is no ghost, and a message
/// says why.
static void open_ghost(App* app, const char* path, const SceneSet* set, int set_count) {
    Ghost* ghost = app->options->ghost;
    if (!ghost)
        return;
    world_close(&ghost->world);
    char method[80];
    SceneSet all[MAP_SETS + 1];
    ASSERT(set_count <= MAP_SETS, "a scene's overrides and a cell's");
    for (int k = 0; k < set_count; k++)
        all[k] = set[k];
    all[set_count].text = method;
    snprintf(method, sizeof method, "method=%s", app->options->compare);
    WorldDef def;
    Fault fault = {0};
    *ghost = (Ghost){0};
    const bool good = scene_load(path, all, set_count + 1, &def, &fault) &&
                      world_open(&ghost->world, &def, &fault);
    if (!good)
        app_say(app, "%s: %s", fault.location, fault.text);
    session_compare(&app->session, good ? ghost : NULL);
}

bool app_open_scene(App* app, const char* path, const SceneSet* set, int set_count, const char* how,
                    Fault* fault) {
    WorldDef def;
    World next;
    if (!scene_load(path, set, set_count, &def, fault))
        return false;
    scene_say_renamed(&def);
    const Mode* mode = mode_of(&def, fault);
    if (!mode) {
        scene_free(&def);
        return false;
    }
    if (!world_open(&next, &def, fault))
        return false;

    // the picture points into the worlds that are closed next
    picture_close(&app->picture);
    open_ghost(app, path, set, set_count);
    app->mode = mode;
    const bool logged = session_change(&app->session, &next, how, fault);
    reset_view(app);
    return logged;
}

void app_next_scene(App* app, int direction) {
    char** path;
    const int count = scene_list(&path);
    const int present = scene_index(path, count, app->world->def.file);
    const int from = present < 0 && direction < 0 ? count : present;
    Fault fault = {0};
    if (count > 0 &&
        !app_open_scene(app, path[(from + direction + count) % count], NULL, 0, NULL, &fault)) {
        app_say(app, "%s: %s", fault.location, fault.text);
    } else {
        app->set_count = app->notch = 0;
        if (app->options->advice) // it is of the scene that was left
            advise_later_close(app->options->advice);
        app->watching = false;
        if (app->lab)
            app_show_lab(app, true);
    }

    for (int k = 0; k < count; k++)
        free(path[k]);
    free(path);
}

// ---- the lab ----

/// The cost of a step is plotted in a window or with --time; other pictures must not depend on it.
void app_show_lab(App* app, bool visible) {
    live_lab_close(app->lab);
    const bool timed = app->output.full_screen || app->options->time;
    app->lab = visible ? live_lab_open(app->world, app->set, app->set_count, timed) : NULL;
}

// ---- screenshots ----

static bool unused_name(const char* folder, char file[600]) {
    for (int number = 1; number <= MAX_SCREENSHOTS; number++) {
        snprintf(file, 600, "%s%sballoon-%04d.png", folder ? folder : "", folder ? "/" : "",
                 number);
        if (access(file, F_OK) != 0)
            return true;
    }
    return false;
}

void app_screenshot(App* app) {
    app->screenshot = false;
    char file[600];
    if (!unused_name(app->options->screenshots, file)) {
        app_say(app, "there are %d screenshots here already", MAX_SCREENSHOTS);
        return;
    }
    unsigned char* rgb = new_array(unsigned char, 3 * (size_t)app->width * (size_t)app->height);
    renderer_read(app->renderer, rgb);
    Fault fault = {0};
    if (png_write_rgb(file, rgb, app->width, app->height, &fault))
        app_say(app, "%s", file);
    else
        app_say(app, "%s: %s", fault.location, fault.text);
    free(rgb);
}

// ---- opening and closing ----

static void list_keys(Overlay* overlay) {
    overlay->key_count = 0;
    for (int k = 0; k < keys_count() && k < OVERLAY_KEYS; k++)
        overlay->key[overlay->key_count++] = keys_row(k);
}

static const Mode* first_mode(const App* app, Fault* fault) {
    const char* name = app->options->mode;
    if (!name)
        return mode_of(&app->world->def, fault);
    if (!mode_find(name))
        fault_set(fault, name, "no such display mode; there are %s", mode_names());
    return mode_find(name);
}

static bool open_renderer(App* app, Fault* fault) {
    char shaders[512];
    if (!paths_own("shaders", "frame.glsl", shaders, fault))
        return false;
    *strrchr(shaders, '/') = 0;
    return renderer_open(&app->renderer, app->width, app->height, shaders, fault);
}

bool app_begin(App* app, World* world, Fault* fault) {
    const ShowOptions* options = app->options;
    app->world = world;
    app->set = options->set;
    app->set_count = options->set_count;
    app->mode = first_mode(app, fault);
    if (!app->mode || !session_open(&app->session, world, options->input, options->record, fault))
        return false;
    session_compare(&app->session, options->ghost);
    return true;
}

bool app_open(App* app, Fault* fault) {
    const ShowOptions* options = app->options;
    app->width = options->width;
    app->height = options->height;
    app->overlay.status_visible = options->overlay;
    list_keys(&app->overlay);
    app_show_lab(app, options->lab);
    reset_view(app);
    return open_renderer(app, fault);
}

bool app_display_lost(const App* app, Fault* fault) {
    return app->output.lost && app->output.lost(app->output.self, fault);
}

bool app_close(App* app, bool complete, Fault* fault) {
    complete = session_close(&app->session, fault) && complete;
    if (!app_display_lost(app, fault)) {
        if (app->overlay_scale > 0)
            hud_close();
        renderer_close(app->renderer);
    }
    picture_close(&app->picture);
    live_lab_close(app->lab);
    return app->output.close(app->output.self, complete, fault);
}
