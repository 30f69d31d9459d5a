/// What every shader knows of the picture: the camera, the size in pixels, the floor. One uniform
/// block, filled once a picture; its twin in GLSL is shaders/frame.glsl.
#ifndef BALLOON_DRAW_FRAME_H
#define BALLOON_DRAW_FRAME_H

#include "draw/gl.h"
#include "view/picture.h"

enum { FRAME_BINDING = 0 };

/// std140: only vectors of four floats, so that C and GLSL lay it out alike.
typedef struct FrameBlock {
    float view_projection[16]; ///< column-major, world to clip space
    float eye[4];              ///< x y z, spare
    float corner[4];           ///< from the eye to the picture's lower left, one unit before it
    float right[4];            ///< from one pixel there to the next
    float up[4];               ///< … to the one above
    float size[4];   ///< width [px], height [px], that of a pixel at distance 1, px per 720th
    float ground[4]; ///< middle x z of the scene, its radius, floor height
    float shadow[4]; ///< lower corner x z of the shadow map, 1 / its width, spare
} FrameBlock;

/// The block as a picture of this size sees the world.
FrameBlock frame_block(const Picture* picture, int width, int height);

/// A buffer bound to FRAME_BINDING; 0 is never returned.
GLuint frame_open(void);
void frame_write(GLuint frame, const FrameBlock* block);

#endif
