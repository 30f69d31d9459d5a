/// Data that all shaders share: camera, picture size, floor. One uniform block, written once for
/// each picture; shaders/frame.glsl declares the same block in GLSL.
#ifndef BALLOON_DRAW_FRAME_H
#define BALLOON_DRAW_FRAME_H

#include "draw/gl.h"
#include "view/picture.h"

enum { FRAME_BINDING = 0 };

/// std140: every member is a vector of four floats, so that the layouts in C and GLSL agree.
/// The image plane is the picture as a rectangle at distance 1 in front of the eye.
typedef struct FrameBlock {
    float view_projection[16]; ///< column-major, world to clip space
    float eye[4];              ///< x y z, unused
    float corner[4];           ///< vector from the eye to the image plane's lower left corner
    float right[4];            ///< vector from a pixel of the image plane to its right neighbor
    float up[4];               ///< vector to the pixel above
    float size[4];   ///< width [px], height [px], height of a pixel at distance 1, height / 720
    float ground[4]; ///< center x z of the scene, its radius, floor height
    float shadow[4]; ///< corner of least x and z of the shadow map, 1 / its width, unused
} FrameBlock;

/// The block for a picture of this size in pixels.
FrameBlock frame_block(const Picture* picture, int width, int height);

/// A new uniform buffer, bound to FRAME_BINDING.
GLuint frame_open(void);
void frame_write(GLuint frame, const FrameBlock* block);

#endif
