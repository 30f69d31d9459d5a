#include "draw/target.h"

static GLuint storage(GLsizei samples, GLenum format, int width, int height) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    return buffer;
}

static void attach(GLuint framebuffer, GLenum point, GLuint renderbuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
}

Target target_open(int width, int height) {
    Target target = {.width = width, .height = height};

    // the shaders write display values, so the formats are not sRGB: blending and resolving work on
    // display values, and the copy to the window converts nothing
    target.color = storage(TARGET_SAMPLES, GL_RGBA8, width, height);
    target.depth = storage(TARGET_SAMPLES, GL_DEPTH_COMPONENT24, width, height);
    target.plain = storage(0, GL_RGBA8, width, height);

    glGenFramebuffers(1, &target.drawn);
    attach(target.drawn, GL_COLOR_ATTACHMENT0, target.color);
    attach(target.drawn, GL_DEPTH_ATTACHMENT, target.depth);
    glGenFramebuffers(1, &target.resolved);
    attach(target.resolved, GL_COLOR_ATTACHMENT0, target.plain);
    return target;
}

void target_resize(Target* target, int width, int height) {
    if (target->width == width && target->height == height)
        return;
    target_close(target);
    *target = target_open(width, height);
}

void target_begin(const Target* target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target->drawn);
    glViewport(0, 0, target->width, target->height);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void target_resolve(const Target* target) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target->drawn);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target->resolved);
    glBlitFramebuffer(0, 0, target->width, target->height, 0, 0, target->width, target->height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target->resolved);
}

void target_close(Target* target) {
    glDeleteFramebuffers(2, (GLuint[]){target->drawn, target->resolved});
    glDeleteRenderbuffers(3, (GLuint[]){target->color, target->depth, target->plain});
    *target = (Target){0};
}
