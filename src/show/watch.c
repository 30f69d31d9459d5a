/// A cell of the lab's map, watched: the scene with its step and stiffness.
#include "show/app.h"

#include <stdio.h>

/// "--set guard="off" --set step=0.004 …": what the log needs beside its scene.
static void say_how(const MapSets* sets, char* how, size_t size) {
    size_t used = (size_t)snprintf(how, size, "with");
    for (int k = 0; k < sets->words && used < size; k++)
        used += (size_t)snprintf(how + used, size - used, " --set '%s'", sets->word[k]);
}

/// The eye, the display mode and the choice stay.
static bool change(App* app, const SceneSet* set, int count, const char* how) {
    const Camera camera = app->camera;
    const Mode* mode = app->mode;
    char file[512];
    Fault fault = {0};
    snprintf(file, sizeof file, "%s", app->world->def.file);
    if (!app_open_scene(app, file, set, count, how, &fault)) {
        app_say(app, "%s: %s", fault.place, fault.text);
        return false;
    }
    app->camera = camera;
    app->mode = mode;
    return true;
}

void app_watch(App* app) {
    char how[MAP_WORDS * (MAP_WORD + 10)];
    MapSets sets;
    if (!app->lab) {
        app_say(app, "g shows the lab's map, on which to choose");
        return;
    }
    const PageMap* map = &app->lab->page.map;
    map_sets(&app->lab->map, map->chosen[0], map->chosen[1], &sets);
    say_how(&sets, how, sizeof how);
    if (!change(app, sets.set, sets.count, how))
        return;
    app->watching = true;
    app_say(app, "step %.3g ms, stiffness x %g, unguarded; backspace brings the scene back",
            1e3 * app->world->step, map_stiffness(map->chosen[0]));
}

void app_watch_no_more(App* app) {
    if (app->watching && change(app, app->set, app->set_count, NULL)) {
        app->watching = false;
        app_say(app, "the scene as it was");
    }
}
