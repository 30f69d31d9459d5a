/// The framebuffers: one with depth and four samples a pixel to draw into, and a plain one that it
/// is resolved to, which captures read and the window displays.
#ifndef BALLOON_DRAW_TARGET_H
#define BALLOON_DRAW_TARGET_H

#include "draw/gl.h"

enum { TARGET_SAMPLES = 4 };

typedef struct Target {
    int width, height;          ///< [px]
    GLuint drawn, color, depth; ///< framebuffer and its two renderbuffers, TARGET_SAMPLES each
    GLuint resolved, plain;     ///< framebuffer and its one renderbuffer
} Target;

Target target_open(int width, int height);
void target_resize(Target* target, int width, int height);

/// Bind for drawing, and clear color and depth.
void target_begin(const Target* target);
/// Average the samples, and leave the resolved framebuffer bound.
void target_resolve(const Target* target);

void target_close(Target* target);

#endif
