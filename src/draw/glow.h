/// The soft outline around what is selected: its shape in a small texture, blurred, and laid over
/// the resolved picture where the shape itself is not.
#ifndef BALLOON_DRAW_GLOW_H
#define BALLOON_DRAW_GLOW_H

#include "draw/skins.h"

enum { GLOW_SHRINK = 4 }; ///< pixels of the picture per pixel of the glow, each direction

typedef struct Glow {
    GLuint mask, blur, lay; ///< programs: the shape, one direction of its blur, onto the picture
    GLuint empty;           ///< vertex array without attributes
    GLint direction;        ///< uniform of `blur`: one pixel along its direction
    GLuint framebuffer[2], texture[2];
    int width, height; ///< of the picture [px]
} Glow;

bool glow_open(Glow* glow, int width, int height, const char* shader_dir, Fault* fault);
void glow_resize(Glow* glow, int width, int height);
/// Over the framebuffer `onto`, which is left bound; nothing when nothing is selected.
void glow_draw(const Glow* glow, const Skins* skins, GLuint onto);
void glow_close(Glow* glow);

#endif
