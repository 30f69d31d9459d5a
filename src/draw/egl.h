/// The one EGL path: an OpenGL 3.3 core context without a window (surfaceless), or the one that the
/// window library made through EGL. After either, the context is current and draw/renderer works.
#ifndef BALLOON_DRAW_EGL_H
#define BALLOON_DRAW_EGL_H

#include "base/fault.h"

/// Handles as void* so that no one else needs EGL's headers.
typedef struct Egl {
    void* display;
    void* surface; ///< EGL_NO_SURFACE when headless
    void* context;
} Egl;

/// Make a surfaceless context current. False with a sentence (which EGL call, which error, and
/// what to install) when this machine cannot.
bool egl_open_surfaceless(Egl* egl, Fault* fault);
void egl_close_surfaceless(Egl* egl);

#endif
