/// Draws a Picture into an own 4x multisampled framebuffer and resolves it to a plain one, which
/// captures read and the window shows. The pixels are the same in the window and headless.
///
/// A context must be current (draw/egl.h) from open to close.
#ifndef BALLOON_DRAW_RENDERER_H
#define BALLOON_DRAW_RENDERER_H

#include "base/fault.h"
#include "view/picture.h"

typedef struct Renderer Renderer;

/// Milliseconds of the last frame by stage, as the caller's thread saw them.
typedef struct RendererTimes {
    double upload;  ///< [ms] arrays to the driver
    double shadow;  ///< [ms] the floor's shadow
    double scene;   ///< [ms] floor, skins, balls, lines
    double resolve; ///< [ms] multisample resolve
} RendererTimes;

/// shader_dir: where the .vert and .frag files are. False with file, line and the compiler's
/// message when a shader does not compile, or GL is older than 3.3.
bool renderer_open(Renderer** renderer, int width, int height, const char* shader_dir,
                   Fault* fault);
void renderer_resize(Renderer* renderer, int width, int height);

void renderer_draw(Renderer* renderer, const Picture* picture);

/// Bind the resolved framebuffer, for the overlay to draw on top; renderer_draw leaves it bound.
void renderer_bind_resolved(const Renderer* renderer);

/// The resolved picture, upper row first, 3 bytes a pixel: rgb[height * width * 3].
void renderer_read(const Renderer* renderer, unsigned char* rgb);

/// Copy the resolved picture to the window's own framebuffer.
void renderer_show(const Renderer* renderer);

RendererTimes renderer_times(const Renderer* renderer);
void renderer_close(Renderer* renderer);

#endif
