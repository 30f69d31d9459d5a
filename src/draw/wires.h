/// Strings, springs and arrows: straight lines as quads that face the eye, shaded like thin round
/// wires.
///
/// They are drawn twice: before translucent skins, which blend over lines behind them, and after
/// them for the lines in front of a skin or on it. A small offset toward the eye puts lines that
/// lie on a surface in front of it.
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
