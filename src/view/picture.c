#include "view/picture.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "view/field.h"
#include "view/mode.h"
#include "view/string_lines.h"
#include "view/spheres.h"
#include "view/surface.h"
#include "view/thing_surface.h"
#include "world/world.h"

/// The maximum number of lines, or of balls, of a balloon over all modes.
static int max_count(const Balloon* balloon, bool balls) {
    int max = 0;
    for (int m = 0; m < mode_count; m++) {
        int (*count)(const Balloon*) = balls ? mode_table[m]->balls : mode_table[m]->lines;
        const int added = count ? count(balloon) : 0;
        max = added > max ? added : max;
    }
    return max;
}

/// Grow the array of balls to hold knots, the balls of any mode, and the world's; contents are lost.
static void ensure_capacity(Picture* picture, int spheres) {
    if (picture->ball && picture->ball_reserved + spheres <= picture->ball_capacity)
        return;
    free(picture->ball);
    picture->ball_capacity = picture->ball_reserved + 2 * spheres;
    picture->ball = new_array(PictureBall, picture->ball_capacity);
}

void picture_open(Picture* picture, const World* world) {
    *picture = (Picture){
        .skin = new_array(PictureSkin, world->balloon_count + world->thing_count),
        .skin_count = world->balloon_count + world->thing_count,
        .balloon_count = world->balloon_count,
        .thing_count = world->thing_count,
        .floor = world->def.floor != NULL,
        .floor_height = world->def.floor ? (float)*world->def.floor : 0,
    };
    for (int b = 0; b < world->balloon_count; b++) {
        const Balloon* balloon = &world->balloon[b];
        surface_open(&picture->skin[b], balloon);
        // the key that ties strings adds one to a balloon without any
        const int strings = balloon->strings > 0 ? balloon->strings : 1;
        picture->line_capacity += max_count(balloon, false) + STRING_SEGMENTS * strings;
        picture->ball_reserved += max_count(balloon, true) + STRING_KNOTS * strings;
    }
    picture->line_capacity += STRING_SEGMENTS * world->system.joints.count;
    picture->ball_reserved += STRING_KNOTS * world->system.joints.count;
    for (int k = 0; k < world->thing_count; k++)
        thing_surface_open(&picture->skin[world->balloon_count + k], &world->thing[k],
                           world->def.things[k].color);
    picture->line = new_array(PictureLine, picture->line_capacity);
    ensure_capacity(picture, world->contacts.sphere_count);
}

void picture_ghost(Picture* picture, const World* ghost) {
    const int own = picture->skin_count;
    PictureSkin* skin = new_array(PictureSkin, own + ghost->balloon_count);
    memcpy(skin, picture->skin, (size_t)own * sizeof *skin);
    free(picture->skin);
    picture->skin = skin;
    for (int b = 0; b < ghost->balloon_count; b++) {
        surface_open(&skin[own + b], &ghost->balloon[b]);
        skin[own + b].paint = PAINT_GHOST;
    }
    picture->skin_count += ghost->balloon_count;
    picture->ghost = ghost;
}

static void widen(float low[3], float high[3], const float point[3], float radius) {
    for (int k = 0; k < 3; k++) {
        low[k] = fminf(low[k], point[k] - radius);
        high[k] = fmaxf(high[k], point[k] + radius);
    }
}

/// Bounding sphere of the bounding box of all skins, knots and nearby balls.
static void bound(Picture* picture, const World* world) {
    float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
    for (int b = 0; b < picture->skin_count; b++)
        for (int i = 0; i < picture->skin[b].point_count; i++)
            widen(low, high, picture->skin[b].position[i], 0);
    for (int b = 0; b < picture->ball_count; b++)
        widen(low, high, picture->ball[b].center, picture->ball[b].radius);
    spheres_widen(world, low, high);

    float square = 0;
    for (int k = 0; k < 3; k++) {
        const float half = 0.5f * (high[k] - low[k]);
        picture->scene_center[k] = low[k] + half;
        square += half * half;
    }
    picture->scene_radius = sqrtf(square);
    ASSERT(isfinite(picture->scene_radius), "a picture is made of finite numbers");
}

/// Pictures that differ have different stamps.
static long next_stamp(void) {
    static long stamp;
    return ++stamp;
}

void picture_update(Picture* picture, const World* world, const Camera* camera, const Mode* mode) {
    const int balls = picture->ball_count;
    picture->camera = *camera;
    picture->line_count = picture->ball_count = 0;
    picture->changed = picture->stamp == 0; // the first picture
    ensure_capacity(picture, world->contacts.sphere_count);

    for (int b = 0; b < world->balloon_count; b++) {
        PictureSkin* skin = &picture->skin[b];
        const SkinPaint paint = mode_fits(mode, &world->balloon[b]) ? mode->paint : PAINT_RUBBER;
        const bool selected = b == world->selected;
        picture->changed |= paint != skin->paint || selected != skin->selected;
        skin->paint = paint;
        skin->selected = selected;
        picture->changed |= surface_update(skin, &world->balloon[b]);
        string_lines_add(picture, &world->balloon[b]);
    }
    string_lines_add_joints(picture, world);
    PictureSkin* thing = &picture->skin[world->balloon_count];
    for (int k = 0; k < picture->thing_count; k++)
        picture->changed |= thing_surface_update(&thing[k], &world->thing[k]);
    PictureSkin* ghost = &thing[picture->thing_count];
    for (int b = 0; picture->ghost && b < picture->ghost->balloon_count; b++)
        picture->changed |= surface_update(&ghost[b], &picture->ghost->balloon[b]);
    bound(picture, world);
    spheres_add(picture, world);

    if (mode->measure)
        field_update(picture, world, mode);
    for (int b = 0; mode->fill && b < world->balloon_count; b++)
        if (mode_fits(mode, &world->balloon[b]))
            mode->fill(picture, &picture->skin[b], &world->balloon[b]);
    if (picture->changed || picture->ball_count != balls)
        picture->stamp = next_stamp();
}

void picture_line(Picture* picture, const float from[3], const float to[3], const float color[3],
                  float width) {
    ASSERT(picture->line_count < picture->line_capacity, "each mode says how many lines it draws");
    picture->line[picture->line_count++] = (PictureLine){
        .from = {from[0], from[1], from[2]},
        .to = {to[0], to[1], to[2]},
        .color = {color[0], color[1], color[2]},
        .width = width,
    };
}

void picture_ball(Picture* picture, const float center[3], float radius, const float color[3]) {
    ASSERT(picture->ball_count < picture->ball_capacity, "each mode says how many balls it draws");
    const PictureBall ball = {
        .center = {center[0], center[1], center[2]},
        .radius = radius,
        .color = {color[0], color[1], color[2]},
    };
    PictureBall* to = &picture->ball[picture->ball_count++];
    picture->changed |= memcmp(to, &ball, sizeof ball) != 0; // floats only: no padding bytes
    *to = ball;
}

void picture_close(Picture* picture) {
    const int things_end = picture->balloon_count + picture->thing_count;
    for (int b = 0; b < picture->skin_count; b++)
        if (b < picture->balloon_count || b >= things_end)
            surface_close(&picture->skin[b]);
        else
            thing_surface_close(&picture->skin[b]);
    free(picture->skin);
    free(picture->line);
    free(picture->ball);
    *picture = (Picture){0};
}
