/// Pictures of worlds for tests: a scene, its camera and its picture.
#ifndef BALLOON_TESTS_STUDIO_H
#define BALLOON_TESTS_STUDIO_H

#include "view/framing.h"
#include "view/mode.h"
#include "view/picture.h"
#include "worlds.h"

/// One balloon of rubber, as the words of a scene: `more` are further keys of the membrane.
#define RUBBER(model, more)                                                                        \
    "peak", "balloons=[{model: " model ", skin: {membrane: {material: neo-hookean, young: 1e6, "   \
            "density: 1000, thickness: 3e-4" more "}}}]"

typedef struct Studio {
    World world;
    Camera camera;
    Picture picture;
} Studio;

static inline void studio_open(Studio* studio, const char* const* words) {
    *studio = (Studio){0};
    world_of_list(&studio->world, words);
    studio->camera = framing_first(&studio->world);
    picture_open(&studio->picture, &studio->world);
    picture_update(&studio->picture, &studio->world, &studio->camera, &mode_skin);
}

#define STUDIO(studio, ...) studio_open((studio), (const char* const[]){__VA_ARGS__, NULL})

static inline void studio_close(Studio* studio) {
    picture_close(&studio->picture);
    world_close(&studio->world);
}

static inline double dot3(const float* a, const float* b) {
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static inline double distance(const float* a, const float* b) {
    const float d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot3(d, d));
}

static inline void throw_at(World* world, double x, double y, double z, double radius) {
    const Event event = {
        .step = world->clock, .kind = EVENT_THROW, .thrown = {x, y, z, 0, 0, 0, 1, radius}};
    Fault fault = {0};
    assert_true(world_event(world, &event, &fault));
}

#endif
