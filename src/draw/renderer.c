#include "draw/renderer.h"

#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "draw/balls.h"
#include "draw/floor.h"
#include "draw/frame.h"
#include "draw/gl.h"
#include "draw/glow.h"
#include "draw/wires.h"
#include "draw/skins.h"
#include "draw/target.h"

struct Renderer {
    Target target;
    GLuint frame;
    Floor floor;
    Balls balls;
    Wires wires;
    Skins skins;
    Glow glow;
    RendererTimes times;
};

static double now(void) {
    return 1e3 * clock_seconds(CLOCK_MONOTONIC);
}

static bool version_suffices(Fault* fault) {
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (10 * major + minor >= 33)
        return true;
    return fault_set(fault, "OpenGL", "version %d.%d is too old, drawing needs 3.3", major, minor);
}

bool renderer_open(Renderer** renderer, int width, int height, const char* shader_dir,
                   Fault* fault) {
    *renderer = NULL;
    if (!version_suffices(fault))
        return false;

    Renderer* new_renderer = new_array(Renderer, 1);
    new_renderer->target = target_open(width, height);
    new_renderer->frame = frame_open();
    const bool opened = floor_open(&new_renderer->floor, shader_dir, fault) &&
                        balls_open(&new_renderer->balls, shader_dir, fault) &&
                        wires_open(&new_renderer->wires, shader_dir, fault) &&
                        skins_open(&new_renderer->skins, shader_dir, fault) &&
                        glow_open(&new_renderer->glow, width, height, shader_dir, fault);
    if (!opened) {
        renderer_close(new_renderer);
        return false;
    }
    *renderer = new_renderer;
    return true;
}

void renderer_resize(Renderer* renderer, int width, int height) {
    // a minimized window has no pixels; a framebuffer needs at least one
    width = width > 0 ? width : 1;
    height = height > 0 ? height : 1;
    target_resize(&renderer->target, width, height);
    glow_resize(&renderer->glow, width, height);
}

// Upload the picture's arrays; returns the part of the time that the floor's shadow took [ms].
static double upload(Renderer* renderer, const Picture* picture) {
    const FrameBlock block = frame_block(picture, renderer->target.width, renderer->target.height);
    frame_write(renderer->frame, &block);
    balls_upload(&renderer->balls, picture);
    wires_upload(&renderer->wires, picture);
    skins_upload(&renderer->skins, picture, block.eye);

    const double start = now();
    floor_upload(&renderer->floor, picture);
    return now() - start;
}

static void draw_opaque(const Renderer* renderer, const Picture* picture) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);

    // large objects first, so that pixels behind them are not shaded
    skins_draw(&renderer->skins, PAINT_FIELD);
    balls_draw(&renderer->balls);
    wires_draw(&renderer->wires);
    floor_draw(&renderer->floor, picture);
}

static void draw_translucent(const Renderer* renderer) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    // skins blend over the lines behind them and write depth; lines in front are drawn again
    skins_draw(&renderer->skins, PAINT_RUBBER);
    skins_draw(&renderer->skins, PAINT_FAINT);
    if (skins_have_translucent(&renderer->skins))
        wires_draw(&renderer->wires);

    // a ghost is visible through everything and hides nothing
    glDisable(GL_DEPTH_TEST);
    skins_draw(&renderer->skins, PAINT_GHOST);
    glEnable(GL_DEPTH_TEST);
}

void renderer_draw(Renderer* renderer, const Picture* picture) {
    const double start = now();
    const double shadow = upload(renderer, picture);

    const double uploaded = now();
    target_begin(&renderer->target);
    draw_opaque(renderer, picture);
    draw_translucent(renderer);

    const double drawn = now();
    target_resolve(&renderer->target);
    glow_draw(&renderer->glow, &renderer->skins, renderer->target.resolved);

    const double done = now();
    renderer->times = (RendererTimes){.upload = uploaded - start - shadow,
                                      .shadow = shadow,
                                      .scene = drawn - uploaded,
                                      .resolve = done - drawn};
}

void renderer_bind_resolved(const Renderer* renderer) {
    glBindFramebuffer(GL_FRAMEBUFFER, renderer->target.resolved);
    glViewport(0, 0, renderer->target.width, renderer->target.height);
}

void renderer_read(const Renderer* renderer, unsigned char* rgb) {
    const int width = renderer->target.width, height = renderer->target.height;
    unsigned char* rgba = memory_array(4 * (size_t)width, (size_t)height);
    renderer_bind_resolved(renderer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);

    // OpenGL's first row is the lowest
    for (int y = 0; y < height; y++) {
        const unsigned char* from = rgba + 4 * (size_t)width * (size_t)(height - 1 - y);
        for (int x = 0; x < width; x++, from += 4, rgb += 3)
            memcpy(rgb, from, 3);
    }
    free(rgba);
}

void renderer_show(const Renderer* renderer) {
    const int width = renderer->target.width, height = renderer->target.height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, renderer->target.resolved);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

RendererTimes renderer_times(const Renderer* renderer) {
    return renderer->times;
}

void renderer_close(Renderer* renderer) {
    if (!renderer)
        return;
    glow_close(&renderer->glow);
    skins_close(&renderer->skins);
    wires_close(&renderer->wires);
    balls_close(&renderer->balls);
    floor_close(&renderer->floor);
    glDeleteBuffers(1, &renderer->frame);
    target_close(&renderer->target);
    free(renderer);
}
