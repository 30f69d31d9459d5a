/// Glossy balls. Each is one quad that faces the eye; the fragment shader intersects the ray through
/// its pixel with the ball, so a ball is round at any size and costs two triangles.
#ifndef BALLOON_DRAW_BALLS_H
#define BALLOON_DRAW_BALLS_H

#include "base/fault.h"
#include "draw/gl.h"
#include "view/picture.h"

typedef struct Balls {
    GLuint program, array, buffer;
    int count;
} Balls;

bool balls_open(Balls* balls, const char* shader_dir, Fault* fault);
void balls_upload(Balls* balls, const Picture* picture);
void balls_draw(const Balls* balls);
void balls_close(Balls* balls);

#endif
