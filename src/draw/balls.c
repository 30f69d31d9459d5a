#include "draw/balls.h"

#include <stddef.h>

#include "draw/shader.h"

bool balls_open(Balls* balls, const char* shader_dir, Fault* fault) {
    balls->program = shader_load(shader_dir, "ball.vert", "ball.frag", fault);
    glGenVertexArrays(1, &balls->array);
    glGenBuffers(1, &balls->buffer);

    glBindVertexArray(balls->array);
    glBindBuffer(GL_ARRAY_BUFFER, balls->buffer);
    gl_instanced(0, 3, sizeof(PictureBall), offsetof(PictureBall, center));
    gl_instanced(1, 1, sizeof(PictureBall), offsetof(PictureBall, radius));
    gl_instanced(2, 3, sizeof(PictureBall), offsetof(PictureBall, color));
    return balls->program != 0;
}

void balls_upload(Balls* balls, const Picture* picture) {
    balls->count = picture->ball_count;
    if (balls->count == 0)
        return;
    glBindBuffer(GL_ARRAY_BUFFER, balls->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)sizeof(PictureBall) * balls->count, picture->ball,
                 GL_STREAM_DRAW);
}

void balls_draw(const Balls* balls) {
    if (balls->count == 0)
        return;
    glUseProgram(balls->program);
    glBindVertexArray(balls->array);

    // alpha is the fraction of the pixel that the ball covers: it selects as many samples
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, balls->count);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

void balls_close(Balls* balls) {
    glDeleteBuffers(1, &balls->buffer);
    glDeleteVertexArrays(1, &balls->array);
    glDeleteProgram(balls->program);
}
