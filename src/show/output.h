/// Where pictures go and input comes from: a window, or headless frames. The main loop knows only
/// this struct of functions.
///
/// Opening an output makes its OpenGL context current; it stays so until the output is closed.
#ifndef BALLOON_SHOW_OUTPUT_H
#define BALLOON_SHOW_OUTPUT_H

#include "base/fault.h"
#include "draw/renderer.h"

enum { KEYS_A_FRAME = 64 }; ///< more key events in one frame are dropped

/// A key by the name that the key tables use: "a", "space", "page down", "f11".
/// So is a click with a key held: "ctrl+click".
typedef struct KeyEvent {
    char name[16];
    bool down;
    float pointer[2]; ///< where the mouse was, 0…1 from the picture's upper left
} KeyEvent;

/// What happened since the frame before.
typedef struct Input {
    double elapsed;  ///< time to be shown [s]
    double frame_ms; ///< smoothed wall time of a frame [ms]; 0: of no interest
    int width;       ///< of the picture [px]
    int height;      ///< [px]
    float scale;     ///< of the overlay's text: 1 for a plain screen, 2 for a high-density one
    int key_count;
    KeyEvent key[KEYS_A_FRAME];
    float orbit[2]; ///< drags [heights of the window], right and down
    float pan[2];
    float zoom; ///< steps of the wheel, away from the user is closer
} Input;

typedef struct Output {
    void* self;

    /// Wait for the next frame; false when there is none: closed, or all frames are made.
    bool (*next)(void* self, Input* input);

    /// Whether this frame's time for steps is used up. A window must stay alive; headless never.
    bool (*late)(void* self);

    /// Show or write what the renderer has resolved.
    bool (*present)(void* self, const Renderer* renderer, Fault* fault);

    /// Switch between window and full screen; NULL where there is no screen.
    void (*full_screen)(void* self);

    /// `complete`: all went well, files are completed; else what is half-written is removed.
    bool (*close)(void* self, bool complete, Fault* fault);
} Output;

/// A window on this machine's display. False with a sentence when there is none.
bool output_window(Output* output, const char* title, int width, int height, Fault* fault);

typedef struct FramesDef {
    const char* out; ///< a folder for frame-00000.png …, a .png of the last moment, or a video;
                     ///< NULL: frames are made and read back, and nothing is written
    int width;
    int height;
    double fps;
    double seconds; ///< frames show the times 0, 1/fps, … up to this
    bool quiet;     ///< no progress on stderr, no last line
} FramesDef;

/// Headless frames. Whatever cannot be written is found here, before anything is simulated.
bool output_frames(Output* output, const FramesDef* def, Fault* fault);

#endif
