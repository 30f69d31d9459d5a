/// The destination of pictures and source of input: a window, or headless frames. The main loop
/// knows only this struct of functions.
///
/// Opening an output makes its OpenGL context current until the output is closed.
#ifndef BALLOON_SHOW_OUTPUT_H
#define BALLOON_SHOW_OUTPUT_H

#include "base/fault.h"
#include "draw/renderer.h"

enum { MAX_FRAME_KEYS = 64 }; ///< further key events of a frame are dropped

/// A key event, with the key's name in the key tables: "a", "space", "page down", "f11". Mouse
/// clicks are key events, too: "click", "ctrl+click".
typedef struct KeyEvent {
    char name[16];
    bool down;
    float pointer[2]; ///< mouse position, 0…1 from the picture's upper left
} KeyEvent;

/// Input since the last frame.
typedef struct Input {
    double elapsed;  ///< time since the last frame [s]
    double frame_ms; ///< smoothed wall time of a frame [ms]; 0: headless
    int width;       ///< of the picture [px]
    int height;      ///< [px]
    float scale;     ///< of the overlay's text: 1 for a plain screen, 2 for a high-density one
    int key_count;
    KeyEvent key[MAX_FRAME_KEYS];
    float orbit[2]; ///< drag that orbits the camera, right and down [heights of the window]
    float pan[2];   ///< drag that pans the camera, likewise
    float zoom;     ///< steps of the wheel, > 0: zoom in
} Input;

typedef struct Output {
    void* self;

    /// Wait for the next frame; false if there is none: window closed or lost, or all frames done.
    bool (*next)(void* self, Input* input);

    /// Whether this frame's time for steps is used up. A window must respond to input; headless
    /// output is never late.
    bool (*late)(void* self);

    /// Display or write the renderer's resolved picture.
    bool (*present)(void* self, const Renderer* renderer, Fault* fault);

    /// Switch between window and full screen; NULL: headless.
    void (*full_screen)(void* self);

    /// Whether the display went away, and the OpenGL context with it: then a fault. NULL: headless.
    bool (*lost)(void* self, Fault* fault);

    /// complete: finish the files; else remove those that are unfinished.
    bool (*close)(void* self, bool complete, Fault* fault);
} Output;

/// A window on this machine's display; false with a fault if there is no display.
bool output_window(Output* output, const char* title, int width, int height, Fault* fault);

typedef struct FramesDef {
    const char* out; ///< a folder for frame-00000.png …, a .png of the final state, or a video;
                     ///< NULL: frames are drawn and read back but not written
    int width;
    int height;
    double fps;
    double seconds; ///< frames are at times 0, 1/fps, … up to this
    bool quiet;     ///< print no progress and no summary
} FramesDef;

/// Headless frames. An output that cannot be written is a fault here, before any simulation.
bool output_frames(Output* output, const FramesDef* def, Fault* fault);

#endif
