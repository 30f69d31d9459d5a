/// Pictures drawn without a window for tests: a balloon in a studio, and its pixels.
#ifndef BALLOON_TESTS_DRAWN_H
#define BALLOON_TESTS_DRAWN_H

#include "draw/egl.h"
#include "draw/renderer.h"
#include "law.h"

enum { WIDTH = 160, HEIGHT = 120, RINGS = 16, SPOKES = 24 };
enum { POINTS = (RINGS + 1) * SPOKES, TRIANGLES = 2 * RINGS * SPOKES };

/// A ball of rubber over a floor, and the arrays of its picture.
typedef struct Drawn {
    float position[POINTS][3], normal[POINTS][3], tint[POINTS][3], stretch[POINTS];
    int triangle[TRIANGLES][3];
    PictureSkin skin;
    PictureLine line[1];
    PictureBall ball[1];
    Picture picture;
} Drawn;

typedef unsigned char Pixels[HEIGHT][WIDTH][3];

static Egl egl;
static Renderer* renderer;
static Drawn drawn;
static Pixels pixels, others;

// A sphere of rings from pole to pole, wound counter-clockwise from outside.
static inline void blow_up(float radius, float height) {
    for (int i = 0; i < POINTS; i++) {
        const float down = (float)PI * (float)(i / SPOKES) / RINGS;
        const float round = 6.2831853f * (float)(i % SPOKES) / SPOKES;
        const float n[3] = {sinf(down) * sinf(round), cosf(down), sinf(down) * cosf(round)};
        for (int k = 0; k < 3; k++) {
            drawn.normal[i][k] = n[k];
            drawn.position[i][k] = radius * n[k] + (k == 1 ? height : 0);
            drawn.tint[i][k] = k == 2 ? 0.9f : 0.05f;
        }
        drawn.stretch[i] = 1;
    }
    for (int i = 0; i < RINGS * SPOKES; i++) {
        const int ring = i / SPOKES * SPOKES, next = ring + (i + 1) % SPOKES;
        const int quad[4] = {ring + i % SPOKES, ring + i % SPOKES + SPOKES, next + SPOKES, next};
        for (int k = 0; k < 3; k++) {
            drawn.triangle[2 * i][k] = quad[k];
            drawn.triangle[2 * i + 1][k] = quad[(k + 2) % 4];
        }
    }
}

// A red balloon of radius 1 at height 2; nothing else but the floor.
static inline int set_up(void** state) {
    (void)state;
    blow_up(1, 2);
    drawn.skin = (PictureSkin){.point_count = POINTS,
                               .triangle_count = TRIANGLES,
                               .triangle = (const int(*)[3])drawn.triangle,
                               .position = drawn.position,
                               .normal = drawn.normal,
                               .stretch = drawn.stretch,
                               .tint = drawn.tint,
                               .color = {0.7f, 0.02f, 0.02f}};
    drawn.picture =
        (Picture){.skin_count = 1,
                  .skin = &drawn.skin,
                  .line = drawn.line,
                  .line_capacity = 1,
                  .ball = drawn.ball,
                  .ball_capacity = 1,
                  .floor = true,
                  .scene_center = {0, 2, 0},
                  .scene_radius = 1.8f,
                  .camera = {.target = {0, 2, 0}, .distance = 9, .pitch = 0.35f, .field = 0.6f}};
    renderer_resize(renderer, WIDTH, HEIGHT);
    return 0;
}

static inline void draw(Pixels into) {
    renderer_draw(renderer, &drawn.picture);
    renderer_read(renderer, into[0][0]);
}

static inline int brightness(const unsigned char rgb[3]) {
    return rgb[0] + rgb[1] + rgb[2];
}

static inline int open_all(void** state) {
    (void)state;
    Fault fault = {0};
    if (egl_open_surfaceless(&egl, &fault) &&
        renderer_open(&renderer, WIDTH, HEIGHT, "shaders", &fault))
        return 0;
    fault_print(&fault, stderr);
    return 1;
}

static inline int close_all(void** state) {
    (void)state;
    renderer_close(renderer);
    egl_close_surfaceless(&egl);
    return 0;
}

#endif
