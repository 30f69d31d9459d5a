#include "draw/wires.h"

#include <stddef.h>

#include "draw/shader.h"

bool wires_open(Wires* wires, const char* shader_dir, Fault* fault) {
    wires->program = shader_load(shader_dir, "wire.vert", "wire.frag", fault);
    glGenVertexArrays(1, &wires->array);
    glGenBuffers(1, &wires->buffer);

    glBindVertexArray(wires->array);
    glBindBuffer(GL_ARRAY_BUFFER, wires->buffer);
    gl_instanced(0, 3, sizeof(PictureLine), offsetof(PictureLine, from));
    gl_instanced(1, 3, sizeof(PictureLine), offsetof(PictureLine, to));
    gl_instanced(2, 3, sizeof(PictureLine), offsetof(PictureLine, color));
    gl_instanced(3, 1, sizeof(PictureLine), offsetof(PictureLine, width));
    return wires->program != 0;
}

void wires_upload(Wires* wires, const Picture* picture) {
    wires->count = picture->line_count;
    if (wires->count == 0)
        return;
    glBindBuffer(GL_ARRAY_BUFFER, wires->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)sizeof(PictureLine) * wires->count, picture->line,
                 GL_STREAM_DRAW);
}

void wires_draw(const Wires* wires) {
    if (wires->count == 0)
        return;
    glUseProgram(wires->program);
    glBindVertexArray(wires->array);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, wires->count);
}

void wires_close(Wires* wires) {
    glDeleteBuffers(1, &wires->buffer);
    glDeleteVertexArrays(1, &wires->array);
    glDeleteProgram(wires->program);
}
