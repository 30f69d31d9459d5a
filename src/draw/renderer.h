/// Draws a Picture into its own 4x multisampled framebuffer and resolves it to a plain one, which
/// captures read and the window displays. The pixels are the same in the window and headless.
///
/// A context must be current (draw/egl.h) from open to close.
#ifndef BALLOON_DRAW_RENDERER_H
#define BALLOON_DRAW_RENDERER_H

#include "base/fault.h"
#include "view/picture.h"

typedef struct Renderer Renderer;

/// Wall time of the stages of the last frame in the caller's thread.
typedef struct RendererTimes {
    double upload;  ///< [ms] upload of the arrays
    double shadow;  ///< [ms] the floor's shadow
    double scene;   ///< [ms] floor, skins, balls, lines
    double resolve; ///< [ms] multisample resolve
} RendererTimes;

/// shader_dir: folder of the .vert and .frag files. Returns false if OpenGL is older than 3.3 or a
/// shader does not compile; the fault has file, line and the compiler's message.
bool renderer_open(Renderer** renderer, int width, int height, const char* shader_dir,
                   Fault* fault);
void renderer_resize(Renderer* renderer, int width, int height);

void renderer_draw(Renderer* renderer, const Picture* picture);

/// Bind the resolved framebuffer, to draw the overlay on it; renderer_draw also leaves it bound.
void renderer_bind_resolved(const Renderer* renderer);

/// Read the resolved picture, top row first, 3 bytes a pixel: rgb[height * width * 3].
void renderer_read(const Renderer* renderer, unsigned char* rgb);

/// Copy the resolved picture to the window's framebuffer.
void renderer_show(const Renderer* renderer);

RendererTimes renderer_times(const Renderer* renderer);
void renderer_close(Renderer* renderer);

#endif
