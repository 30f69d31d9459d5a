#include "draw/frame.h"

#include <math.h>
#include <string.h>

#include "draw/shadow.h"

// c = a b, column-major
static void multiply(const float a[16], const float b[16], float c[16]) {
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            float sum = 0;
            for (int k = 0; k < 4; k++)
                sum += a[4 * k + row] * b[4 * column + k];
            c[4 * column + row] = sum;
        }
}

// The picture as a rectangle at distance 1 in front of the eye.
static void set_image_plane(FrameBlock* block, const float view[16], float half, float width,
                            float height) {
    const float pixel = 2 * half / height;
    for (int i = 0; i < 3; i++) {
        // the rows of the view's rotation are the camera's axes in the world
        block->right[i] = pixel * view[4 * i];
        block->up[i] = pixel * view[4 * i + 1];
        block->corner[i] =
            -view[4 * i + 2] - 0.5f * (width * block->right[i] + height * block->up[i]);
    }
    memcpy(block->size, (float[]){width, height, pixel, height / 720}, sizeof block->size);
}

FrameBlock frame_block(const Picture* picture, int width, int height) {
    const Camera* camera = &picture->camera;
    FrameBlock block = {.view_projection = {0}};

    float view[16], projection[16];
    camera_view(camera, view);
    camera_projection(camera, (float)width / (float)height, projection);
    multiply(projection, view, block.view_projection);
    camera_eye(camera, block.eye);
    set_image_plane(&block, view, tanf(0.5f * camera->field), (float)width, (float)height);

    const float x = picture->scene_center[0], z = picture->scene_center[2];
    memcpy(block.ground, (float[]){x, z, picture->scene_radius, picture->floor_height},
           sizeof block.ground);

    const float reach = shadow_reach(picture);
    memcpy(block.shadow, (float[]){x - reach, z - reach, 0.5f / reach, 0}, sizeof block.shadow);
    return block;
}

GLuint frame_open(void) {
    GLuint frame = 0;
    glGenBuffers(1, &frame);
    glBindBufferBase(GL_UNIFORM_BUFFER, FRAME_BINDING, frame);
    return frame;
}

void frame_write(GLuint frame, const FrameBlock* block) {
    glBindBufferBase(GL_UNIFORM_BUFFER, FRAME_BINDING, frame);
    glBufferData(GL_UNIFORM_BUFFER, sizeof *block, block, GL_STREAM_DRAW);
}
