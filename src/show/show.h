/// Shows a world: in a window to play with, or as headless frames.
///
/// Both run the same main loop (show/loop.c) and give the same bits for the same events as a run
/// without pictures.
#ifndef BALLOON_SHOW_SHOW_H
#define BALLOON_SHOW_SHOW_H

#include "show/ghost.h"
#include "show/stages.h"

typedef struct ShowOptions {
    int width;           ///< [px]
    int height;          ///< [px]
    double fps;          ///< headless frames per simulated second
    double seconds;      ///< simulated time to show; 0: a window stays until it is closed
    const char* out;     ///< headless: a folder, a .png, a video; NULL: pictures are only made
    const char* input;   ///< input log to be replayed; NULL: none
    const char* record;  ///< file for this session's input log; NULL: none. When the user goes on
                         ///< to other scenes, their logs are record.2, record.3, …
    const SceneSet* set; ///< [set_count] overrides with which the world's scene was loaded
    int set_count;
    const char* mode;        ///< display mode; NULL: what the scene says
    const char* screenshots; ///< folder for screenshots; NULL: where the user is
    const char* compare;     ///< method of a ghost beside the scene; NULL: none
    Ghost* ghost;            ///< with that method, the caller's; NULL: none
    Stages* stages;          ///< where the stages of the last frames go; NULL: nowhere
    bool time;               ///< print the mean time of a frame's stages in the end
    bool quiet;              ///< no progress and notices on stderr
    bool lab;                ///< the lab's panel is drawn
    bool overlay;            ///< status box and sentences are drawn; a bad state is always said
} ShowOptions;

/// 1280 x 720, 60 frames a second, with the overlay; no logs, no end.
ShowOptions show_options_default(void);

/// Play the world in a window until the user leaves. Afterwards `world` is the last scene shown;
/// the caller closes it.
bool show_play(World* world, const ShowOptions* options, Fault* fault);

/// Render the world to options->out, and say where. A state that went bad is a fault, but the
/// frames that show it stay.
bool show_render(World* world, const ShowOptions* options, Fault* fault);

#endif
