/// What the main loop works on: a session, how it is seen, and where the pictures go.
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
    World* world; ///< the caller's, which the session steps
    Pacer pacer;
    long end_step; ///< it ends when world->clock reads this; LONG_MAX: it does not

    const Mode* mode;
    Camera camera;
    Thrower thrower;  ///< the next ball to be thrown
    float pointer[2]; ///< where the mouse was at the key, 0…1 from the upper left
    Picture picture;
    Overlay overlay;
    const SceneSet* set;    ///< [set_count] overrides of the scene, as the command line gave them
    int set_count;          ///< 0 where another scene is on
    int notch;              ///< of the lab's slider, 1 …; 0: the scene as it is
    bool watching;          ///< the scene is that of a cell of the lab's map
    LiveLab* lab;           ///< NULL: not shown, and nothing is measured for it
    char message[512];      ///< a sentence for the user
    double message_seconds; ///< how long it stays [s]

    Output output;
    Renderer* renderer;
    int width;           ///< of the renderer's picture [px]
    int height;          ///< [px]
    Stages stages;       ///< where the time goes
    float overlay_scale; ///< of the overlay that is open; 0: none
    bool screenshot;     ///< the next picture is to be written
    bool quit;
} App;

/// Begin with options, pacer and last set: the display mode and the logs. False when they are
/// wrong, and then nothing is open.
bool app_begin(App* app, World* world, Fault* fault);

/// Go on once the output is open: shaders, camera, picture. False when a shader is wrong; app_close
/// is due all the same.
bool app_open(App* app, Fault* fault);

/// The main loop (show/loop.c), until the output ends or the user quits.
bool app_run(App* app, Fault* fault);

/// Close all that is open. `complete`: all went well, and the output is to be completed. The world
/// stays.
bool app_close(App* app, bool complete, Fault* fault);

/// Camera, thrower, pacer and picture for the world that is open now. The speed stays.
void app_reset_view(App* app);

/// Go on to the scene `direction` places further in the list of shipped scenes. One that does not
/// load says why, and the present one stays.
void app_next_scene(App* app, int direction);

/// Open a scene in the place of the present one, which stays where that fails. how: what is said of
/// its overrides in the log, or NULL.
bool app_open_scene(App* app, const char* path, const SceneSet* set, int set_count, const char* how,
                    Fault* fault);

/// Start the scene again as the chosen cell of the lab's map has it, guard off; and bring it back
/// as it was, from a notch too. Each begins a log of its own, which says what it takes to replay it
/// (show/watch.c).
void app_watch_cell(App* app);
void app_restore_scene(App* app);

/// Start the scene again as a notch of the lab's slider has it, the nearest that there is.
void app_select_notch(App* app, int notch);

/// Show the lab's panel, or take it away.
void app_show_lab(App* app, bool shown);

/// Write the renderer's picture under the next free name, and say which.
void app_screenshot(App* app);

/// Say a sentence in the overlay for a few seconds.
void app_say(App* app, const char* format, ...) __attribute__((format(printf, 2, 3)));

#endif
