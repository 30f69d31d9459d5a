/// The state of the main loop: a session, the view of it, and the output of pictures.
#ifndef BALLOON_SHOW_APP_H
#define BALLOON_SHOW_APP_H

#include "show/live_lab.h"
#include "show/output.h"
#include "show/pacer.h"
#include "show/session.h"
#include "show/show.h"
#include "show/stages.h"
#include "view/thrower.h"
#include "view/mode.h"
#include "view/overlay.h"
#include "view/picture.h"

typedef struct App {
    const ShowOptions* options;
    Session session;
    World* world; ///< owned by the caller, stepped by the session
    Pacer pacer;
    long end_step; ///< the loop ends when world->clock reaches this; LONG_MAX: never

    const Mode* mode;
    Camera camera;
    Thrower thrower;  ///< the next ball to be thrown
    float pointer[2]; ///< mouse position at the last key, 0…1 from the upper left
    Picture picture;
    Overlay overlay;
    const SceneSet* set;    ///< [set_count] overrides of the scene from the command line
    int set_count;          ///< 0 after a change of scene
    int notch;              ///< of the slider, 1 …; 0: the scene's own method and step
    bool watching;          ///< the scene runs with step and stiffness of a cell of the map
    LiveLab* lab;           ///< NULL: hidden, and nothing is measured for it
    char message[512];      ///< a sentence for the user
    double message_seconds; ///< remaining time of the message [s]

    Output output;
    Renderer* renderer;
    int width;           ///< of the renderer's picture [px]
    int height;          ///< [px]
    Stages stages;       ///< times of a frame's stages
    float overlay_scale; ///< scale that hud_open got; 0: not open
    bool screenshot;     ///< write the next picture to a file
    bool quit;
} App;

/// Set the display mode and open the logs; the caller has set options, pacer and end_step. Returns
/// false, with nothing open, if mode or logs are wrong.
bool app_begin(App* app, World* world, Fault* fault);

/// After the output is open: open shaders, camera and picture. Returns false if a shader is wrong;
/// app_close is still needed.
bool app_open(App* app, Fault* fault);

/// The main loop (show/loop.c), until the output ends or the user quits.
bool app_run(App* app, Fault* fault);

/// Whether the display went away, with the fault that says so.
bool app_display_lost(const App* app, Fault* fault);

/// Close everything except the world. complete: no fault so far, finish the output's files.
bool app_close(App* app, bool complete, Fault* fault);

/// Change to the scene `direction` rows further in the list of shipped scenes. If that scene does
/// not load, a message says why and the present scene stays.
void app_next_scene(App* app, int direction);

/// Replace the present scene by another; on failure the present scene stays. how: a comment for the
/// log that names the overrides, or NULL.
bool app_open_scene(App* app, const char* path, const SceneSet* set, int set_count, const char* how,
                    Fault* fault);

/// Restart the scene with step and stiffness of the chosen cell of the map, guard off; and restore
/// the scene's own settings, also from a notch. Each begins a new log, whose comment names the
/// overrides needed to replay it (show/watch.c).
void app_watch_cell(App* app);
void app_restore_scene(App* app);

/// Restart the scene with the settings of a notch of the slider, clamped to those that exist.
void app_select_notch(App* app, int notch);

/// Restart the scene as advised, when the measurement has ended that goes on beside it.
void app_follow_advice(App* app);

/// Show or hide the lab panel.
void app_show_lab(App* app, bool visible);

/// Write the renderer's picture under the next unused name, and print that name in the overlay.
void app_screenshot(App* app);

/// Display a message in the overlay for a few seconds.
void app_say(App* app, const char* format, ...) __attribute__((format(printf, 2, 3)));

#endif
