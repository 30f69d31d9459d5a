/// A GL program from two files of the shader folder.
///
/// GLSL has no #include, so frame.glsl (the uniform block of draw/frame.h) and studio.glsl (the
/// lights and the tone curve) are prepended to every file. The block Frame is bound to
/// FRAME_BINDING; all samplers read texture unit 0.
#ifndef BALLOON_DRAW_SHADER_H
#define BALLOON_DRAW_SHADER_H

#include "base/fault.h"
#include "draw/gl.h"

/// Returns 0 if a file cannot be read, compiled or linked; the fault has file, line and the
/// compiler's message.
GLuint shader_load(const char* dir, const char* vertex, const char* fragment, Fault* fault);

#endif
