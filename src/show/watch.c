/// Restarts the scene with settings chosen in the lab panel: step and stiffness of a cell of the map,
/// or method, step and mesh of a notch of the slider.
#include "show/app.h"

#include <stdio.h>

#include "lab/run/overrides.h"

/// "with --set 'guard="off"' --set 'step=0.004' …": a comment for the log.
static void describe_overrides(const SceneSet* set, int count, char* how, size_t size) {
    size_t used = (size_t)snprintf(how, size, "with");
    for (int k = 0; k < count && used < size; k++)
        used += (size_t)snprintf(how + used, size - used, " --set '%s'", set[k].text);
}

/// Reload the scene; camera and display mode stay.
static bool reload_scene(App* app, const SceneSet* set, int count, const char* how) {
    const Camera camera = app->camera;
    const Mode* mode = app->mode;
    char file[512];
    Fault fault = {0};
    snprintf(file, sizeof file, "%s", app->world->def.file);
    if (!app_open_scene(app, file, set, count, how, &fault)) {
        app_say(app, "%s: %s", fault.location, fault.text);
        return false;
    }
    app->camera = camera;
    app->mode = mode;
    return true;
}

void app_watch_cell(App* app) {
    char how[MAP_WORDS * (MAP_WORD + 10)];
    MapSets sets;
    SceneSet word[MAP_WORDS];
    if (!app->lab) {
        app_say(app, "g shows the lab's map, on which to choose");
        return;
    }
    const LabMap* map = &app->lab->panel.map;
    map_sets(&app->lab->map, map->chosen[0], map->chosen[1], &sets);
    for (int k = 0; k < sets.words; k++)
        word[k].text = sets.word[k];
    describe_overrides(word, sets.words, how, sizeof how);
    if (!reload_scene(app, sets.set, sets.count, how))
        return;
    app->watching = true;
    app->notch = 0;
    app_say(app, "step %.3g ms, stiffness x %g, unguarded; backspace brings the scene back",
            1e3 * app->world->step, map_stiffness(map->chosen[0]));
}

void app_restore_scene(App* app) {
    if ((app->watching || app->notch > 0) && reload_scene(app, app->set, app->set_count, NULL)) {
        app->watching = false;
        app->notch = 0;
        app_say(app, "the scene as it was");
    }
}

/// The overrides of a notch; false if the scene's file does not load any more.
static bool notch_overrides(const App* app, int notch, Overrides* sets, Fault* fault) {
    WorldDef def;
    World original; // refinements of the mesh count from the scene's own
    if (!scene_load(app->world->def.file, app->set, app->set_count, &def, fault) ||
        !world_open(&original, &def, fault))
        return false;
    slider_sets(&app->lab->slider, &original, notch, sets);
    world_close(&original);
    return true;
}

/// Restart the scene with its own overrides and these.
static bool reload_with(App* app, const Overrides* sets) {
    SceneSet set[MAP_SETS];
    char how[MAX_OVERRIDES * 64];
    int count = 0;
    for (; count < app->set_count && count < MAP_SETS - sets->count; count++)
        set[count] = app->set[count];
    const int own = count;
    for (int k = 0; k < sets->count; k++)
        set[count++].text = sets->text[k];
    describe_overrides(set + own, sets->count, how, sizeof how);
    return reload_scene(app, set, count, how);
}

void app_follow_advice(App* app) {
    AdviseLater* advice = app->options->advice;
    Overrides sets;
    char sentence[200] = "";
    if (!advice || !advise_later_ended(advice, &sets, sentence, sizeof sentence))
        return;
    if (!app->options->quiet)
        fprintf(stderr, "balloon: %s\n", sentence);
    if (sets.count == 0 || reload_with(app, &sets))
        app_say(app, "%s", sentence);
}

void app_select_notch(App* app, int notch) {
    if (!app->lab || app->lab->slider.notches == 0) {
        app_say(app, app->lab ? "nothing is measured of this scene yet: balloon advise"
                              : "g shows the lab, with its slider");
        return;
    }
    const int last = app->lab->slider.notches;
    notch = notch < 1 ? 1 : notch > last ? last : notch;
    Overrides sets = {.count = 0};
    Fault fault = {0};
    if (notch == app->notch)
        return;
    if (!notch_overrides(app, notch, &sets, &fault)) {
        app_say(app, "%s: %s", fault.location, fault.text);
        return;
    }
    if (!reload_with(app, &sets))
        return;
    app->watching = false;
    app->notch = notch;
}
