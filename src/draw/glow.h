/// The glow around the outline of selected skins: a mask of their shape in a small texture is
/// blurred and blended over the resolved picture, outside the shape.
#ifndef BALLOON_DRAW_GLOW_H
#define BALLOON_DRAW_GLOW_H

#include "draw/skins.h"

enum { GLOW_SHRINK = 4 }; ///< width of a pixel of the glow in pixels of the picture

typedef struct Glow {
    GLuint mask, blur, composite; ///< programs: draw the shape, blur along one axis, blend
    GLuint empty;                 ///< vertex array without attributes
    GLint direction;              ///< uniform of `blur`: one pixel along its axis
    GLuint framebuffer[2], texture[2];
    int width, height; ///< of the picture [px]
} Glow;

bool glow_open(Glow* glow, int width, int height, const char* shader_dir, Fault* fault);
void glow_resize(Glow* glow, int width, int height);
/// Draw the glow over a framebuffer and leave it bound; does nothing if no skin is selected.
void glow_draw(const Glow* glow, const Skins* skins, GLuint framebuffer);
void glow_close(Glow* glow);

#endif
