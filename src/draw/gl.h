/// OpenGL 3.3 core, its functions as plain prototypes: they come from libOpenGL, no loader. And one
/// shorthand.
#ifndef BALLOON_DRAW_GL_H
#define BALLOON_DRAW_GL_H

#include <stddef.h>

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

/// Attribute `index` of the vertex array and buffer that are bound: `size` floats at `offset` of a
/// struct of `stride` bytes, the next struct for every vertex.
static inline void gl_attribute(GLuint index, int size, size_t stride, size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, (GLsizei)stride, (const void*)offset);
}

/// … the next struct for every instance.
static inline void gl_instanced(GLuint index, int size, size_t stride, size_t offset) {
    gl_attribute(index, size, stride, offset);
    glVertexAttribDivisor(index, 1);
}

#endif
