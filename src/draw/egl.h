/// An OpenGL 3.3 core context without a window, through EGL's surfaceless platform. (A window's
/// context is made by GLFW, also through EGL: show/output_window.c.) After opening, the context is
/// current and draw/renderer.h can be used.
#ifndef BALLOON_DRAW_EGL_H
#define BALLOON_DRAW_EGL_H

#include "base/fault.h"

/// Handles are void*, so that only egl.c needs EGL's headers.
typedef struct Egl {
    void* display;
    void* surface; ///< EGL_NO_SURFACE when headless
    void* context;
} Egl;

/// Make a surfaceless context current. Returns false, and names the EGL call, the error and the
/// packages to install, if this machine has none.
bool egl_open_surfaceless(Egl* egl, Fault* fault);
void egl_close_surfaceless(Egl* egl);

#endif
