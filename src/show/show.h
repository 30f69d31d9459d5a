/// Displays a world in a window, or renders it as headless frames.
///
/// Both run the same main loop (show/loop.c) and give the same bits for the same events as a run
/// without pictures.
#ifndef BALLOON_SHOW_SHOW_H
#define BALLOON_SHOW_SHOW_H

#include "lab/advice/advise_later.h"
#include "show/ghost.h"
#include "show/stages.h"

typedef struct ShowOptions {
    int width;           ///< [px]
    int height;          ///< [px]
    double fps;          ///< headless frames per simulated second
    double seconds;      ///< simulated time; 0: until the window is closed
    const char* out;     ///< headless: a folder, a .png, a video; NULL: pictures are not written
    const char* input;   ///< input log to be replayed; NULL: none
    const char* record;  ///< file for this session's input log; NULL: none. The logs of further
                         ///< scenes are record.2, record.3, …
    const SceneSet* set; ///< [set_count] overrides with which the world's scene was loaded
    int set_count;
    const char* mode;        ///< display mode; NULL: the scene's
    const char* screenshots; ///< folder for screenshots; NULL: the current folder
    const char* compare;     ///< method of the ghost; NULL: none
    AdviseLater* advice;     ///< a measurement that goes on: the scene starts again as it advises;
                             ///< NULL: none
    Ghost* ghost;            ///< with that method, owned by the caller; NULL: none
    Stages* stages;          ///< receives the times of the stages; NULL: not wanted
    bool time;               ///< print the mean time of a frame's stages at the end
    bool quiet;              ///< no progress and notices on stderr
    bool lab;                ///< draw the lab panel
    bool overlay;            ///< draw status box and messages; a blowup is always drawn
} ShowOptions;

/// 1280 x 720, 60 frames a second, with the overlay; no logs, no end.
ShowOptions show_options_default(void);

/// Play the world in a window until it is closed. Afterward `world` is that of the last scene; the
/// caller closes it.
bool show_play(World* world, const ShowOptions* options, Fault* fault);

/// Render the world to options->out, and print that path. A blowup is a fault, but the frames up to
/// it stay.
bool show_render(World* world, const ShowOptions* options, Fault* fault);

#endif
