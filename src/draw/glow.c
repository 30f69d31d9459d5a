#include "draw/glow.h"

#include "draw/shader.h"

static int glow_pixels(int pixels) {
    return (pixels + GLOW_SHRINK - 1) / GLOW_SHRINK;
}

static void make_textures(Glow* glow, int width, int height) {
    glow->width = width;
    glow->height = height;
    glGenTextures(2, glow->texture);
    glGenFramebuffers(2, glow->framebuffer);
    for (int i = 0; i < 2; i++) {
        glBindTexture(GL_TEXTURE_2D, glow->texture[i]);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RG8, glow_pixels(width), glow_pixels(height), 0, GL_RG,
                     GL_UNSIGNED_BYTE, NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glBindFramebuffer(GL_FRAMEBUFFER, glow->framebuffer[i]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               glow->texture[i], 0);
    }
}

static void free_textures(Glow* glow) {
    glDeleteFramebuffers(2, glow->framebuffer);
    glDeleteTextures(2, glow->texture);
}

bool glow_open(Glow* glow, int width, int height, const char* shader_dir, Fault* fault) {
    glow->mask = shader_load(shader_dir, "skin.vert", "glow_mask.frag", fault);
    glow->blur = shader_load(shader_dir, "screen.vert", "glow_blur.frag", fault);
    glow->composite = shader_load(shader_dir, "screen.vert", "glow_composite.frag", fault);
    glow->direction = glow->blur ? glGetUniformLocation(glow->blur, "direction") : -1;
    glGenVertexArrays(1, &glow->empty);
    make_textures(glow, width, height);
    return glow->mask && glow->blur && glow->composite;
}

void glow_resize(Glow* glow, int width, int height) {
    if (glow->width == width && glow->height == height)
        return;
    free_textures(glow);
    make_textures(glow, width, height);
}

static void draw_full_screen(const Glow* glow, GLuint from, GLuint framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindTexture(GL_TEXTURE_2D, from);
    glBindVertexArray(glow->empty);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void glow_draw(const Glow* glow, const Skins* skins, GLuint framebuffer) {
    if (skins->selected.count == 0)
        return;
    const int width = glow_pixels(glow->width), height = glow_pixels(glow->height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glViewport(0, 0, width, height);

    // mask of the shape: white on black
    glBindFramebuffer(GL_FRAMEBUFFER, glow->framebuffer[0]);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(glow->mask);
    skins_draw_selected(skins);

    // blurred along x, then along y
    glUseProgram(glow->blur);
    glUniform2f(glow->direction, 1 / (float)width, 0);
    draw_full_screen(glow, glow->texture[0], glow->framebuffer[1]);
    glUniform2f(glow->direction, 0, 1 / (float)height);
    draw_full_screen(glow, glow->texture[1], glow->framebuffer[0]);

    glViewport(0, 0, glow->width, glow->height);
    glEnable(GL_BLEND);
    glUseProgram(glow->composite);
    draw_full_screen(glow, glow->texture[0], framebuffer);
}

void glow_close(Glow* glow) {
    free_textures(glow);
    glDeleteVertexArrays(1, &glow->empty);
    glDeleteProgram(glow->mask);
    glDeleteProgram(glow->blur);
    glDeleteProgram(glow->composite);
}
