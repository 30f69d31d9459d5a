/// OpenGL 3.3 core with plain prototypes: libOpenGL exports the functions, no loader is needed.
#ifndef BALLOON_DRAW_GL_H
#define BALLOON_DRAW_GL_H

#include <stddef.h>

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

/// Set attribute `index` of the bound vertex array from the bound buffer: `size` floats at `offset`
/// of a struct of `stride` bytes; one struct for each vertex.
static inline void gl_attribute(GLuint index, int size, size_t stride, size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, (GLsizei)stride, (const void*)offset);
}

/// The same with one struct for each instance.
static inline void gl_instanced(GLuint index, int size, size_t stride, size_t offset) {
    gl_attribute(index, size, stride, offset);
    glVertexAttribDivisor(index, 1);
}

#endif
