/// A GL program made of two files of the shader folder.
///
/// GLSL has no include: before every file stand frame.glsl (what all shaders know of the picture)
/// and studio.glsl (the lights and the tone curve that all surfaces share). The block Frame is
/// bound to FRAME_BINDING; samplers are all on texture unit 0.
#ifndef BALLOON_DRAW_SHADER_H
#define BALLOON_DRAW_SHADER_H

#include "base/fault.h"
#include "draw/gl.h"

/// 0 and a fault with file, line and the compiler's sentence when it cannot be read or compiled.
GLuint shader_load(const char* dir, const char* vertex, const char* fragment, Fault* fault);

#endif
