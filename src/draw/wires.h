/// Strings, springs and arrows: straight lines as quads that face the eye, shaded like thin round
/// wires.
///
/// They are drawn twice: before the skins, so that they show through them, and after them, so
/// that those in front of a skin or on it lie on top. A small step towards the eye decides for
/// lines that lie on a surface.
#ifndef BALLOON_DRAW_WIRES_H
#define BALLOON_DRAW_WIRES_H

#include "base/fault.h"
#include "draw/gl.h"
#include "view/picture.h"

typedef struct Wires {
    GLuint program, array, buffer;
    int count;
} Wires;

bool wires_open(Wires* wires, const char* shader_dir, Fault* fault);
void wires_upload(Wires* wires, const Picture* picture);
void wires_draw(const Wires* wires);
void wires_close(Wires* wires);

#endif
