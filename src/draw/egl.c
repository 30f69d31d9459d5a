#include "draw/egl.h"

#include <stddef.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "draw/gl.h"

// clang-format off
static const EGLint CONFIG[] = {
    EGL_SURFACE_TYPE,    EGL_DONT_CARE, // no surface is made
    EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_NONE,
};

static const EGLint CONTEXT[] = {
    EGL_CONTEXT_MAJOR_VERSION,       3,
    EGL_CONTEXT_MINOR_VERSION,       3,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
    EGL_NONE,
};
// clang-format on

static const char* error_name(EGLint error) {
    switch (error) {
        case EGL_NOT_INITIALIZED:
            return "EGL_NOT_INITIALIZED";
        case EGL_BAD_ALLOC:
            return "EGL_BAD_ALLOC";
        case EGL_BAD_ATTRIBUTE:
            return "EGL_BAD_ATTRIBUTE";
        case EGL_BAD_CONFIG:
            return "EGL_BAD_CONFIG";
        case EGL_BAD_DISPLAY:
            return "EGL_BAD_DISPLAY";
        case EGL_BAD_MATCH:
            return "EGL_BAD_MATCH";
        case EGL_BAD_PARAMETER:
            return "EGL_BAD_PARAMETER";
        default:
            return "error";
    }
}

static bool fail(Egl* egl, Fault* fault, const char* call) {
    const EGLint error = eglGetError();
    egl_close_surfaceless(egl);
    return fault_set(fault, call,
                     "no OpenGL 3.3 without a window on this machine (%s 0x%04x); Mesa's software "
                     "renderer gives it: apt-get install libegl1 libopengl0 libgl1-mesa-dri",
                     error_name(error), (unsigned)error);
}

bool egl_open_surfaceless(Egl* egl, Fault* fault) {
    *egl = (Egl){.display = EGL_NO_DISPLAY, .surface = EGL_NO_SURFACE, .context = EGL_NO_CONTEXT};

    // the surfaceless platform needs neither X nor a screen, unlike the default display
    egl->display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (egl->display == EGL_NO_DISPLAY)
        return fail(egl, fault, "eglGetPlatformDisplay");
    if (!eglInitialize(egl->display, NULL, NULL))
        return fail(egl, fault, "eglInitialize");

    EGLConfig config;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API))
        return fail(egl, fault, "eglBindAPI");
    if (!eglChooseConfig(egl->display, CONFIG, &config, 1, &count) || count < 1)
        return fail(egl, fault, "eglChooseConfig");

    egl->context = eglCreateContext(egl->display, config, EGL_NO_CONTEXT, CONTEXT);
    if (egl->context == EGL_NO_CONTEXT)
        return fail(egl, fault, "eglCreateContext");
    if (!eglMakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context))
        return fail(egl, fault, "eglMakeCurrent");
    return true;
}

void egl_close_surfaceless(Egl* egl) {
    if (egl->display == EGL_NO_DISPLAY)
        return;
    eglMakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (egl->context != EGL_NO_CONTEXT)
        eglDestroyContext(egl->display, egl->context);

    // the display stays open until the process ends: closing it unloads Mesa's driver with memory
    // still allocated, and leak checkers then report addresses in unloaded code
    eglReleaseThread();
    *egl = (Egl){.display = EGL_NO_DISPLAY, .surface = EGL_NO_SURFACE, .context = EGL_NO_CONTEXT};
}
