/// Worlds for tests: of a shipped scene, of a mesh, or of a text.
#ifndef BALLOON_TESTS_WORLDS_H
#define BALLOON_TESTS_WORLDS_H

#include <unistd.h>

#include "law.h"
#include "world/probe.h"
#include "world/world.h"

/// Scene or mesh by name, with overrides up to the first NULL.
static inline void world_of(World* world, const char* name, const char* const* set) {
    SceneSet sets[16] = {{NULL}};
    int count = 0;
    for (; set && set[count]; count++)
        sets[count].text = set[count];
    WorldDef def;
    Fault fault = {0};
    if (!scene_load(name, sets, count, &def, &fault) || !world_open(world, &def, &fault)) {
        fault_print(&fault, stderr);
        fail();
    }
}

/// WORLD_OF(&world, "party", "step=0.001", …): the overrides may be none.
#define WORLD_OF(world, ...) world_of_list((world), (const char* const[]){__VA_ARGS__, NULL})

static inline void world_of_list(World* world, const char* const* words) {
    world_of(world, words[0], words + 1);
}

/// The path of a file of this text, which the caller removes.
static inline const char* file_of(const char* text, const char* extension) {
    static char path[64];
    snprintf(path, sizeof path, "/tmp/balloon-world-%ld%s", (long)getpid(), extension);
    FILE* out = fopen(path, "w");
    assert_non_null(out);
    assert_true(fputs(text, out) >= 0 && fclose(out) == 0);
    return path;
}

/// OPEN_TEXT(&world, text, "step=0.001", …): a scene of this text; the overrides may be none.
#define OPEN_TEXT(world, ...) open_text((world), (const char* const[]){__VA_ARGS__, NULL})

static inline void open_text(World* world, const char* const* words) {
    const char* path = file_of(words[0], ".yaml");
    world_of(world, path, words + 1);
    remove(path);
}

/// Of the first balloon [N].
static inline double balloon_weight(const World* world) {
    const Body* body = &world->balloon[0].body;
    double mass = 0;
    for (int i = 0; i < body->count; i++)
        mass += (double)body->mass[i];
    return mass * body->gravity;
}

static inline void run_for(World* world, double seconds) {
    const long until = world->clock + lround(seconds / world->step);
    while (world->clock < until)
        world_step(world);
}

static inline void press(World* world, const char* name, const char* value) {
    Event event = {.step = world->clock, .kind = EVENT_KEY};
    snprintf(event.name, sizeof event.name, "%s", name);
    snprintf(event.value, sizeof event.value, "%s", value);
    Fault fault = {0};
    assert_true(world_event(world, &event, &fault));
}

static inline double probe(const World* world, const char* column) {
    double value = 0;
    if (!probe_value(world, column, &value))
        fail_msg("no column %s", column);
    return value;
}

static inline bool is_finite(const World* world) {
    for (int b = 0; b < world->balloon_count; b++) {
        const Body* body = &world->balloon[b].body;
        for (int i = 0; i < body->count; i++)
            for (int k = 0; k < 3; k++)
                if (!isfinite(body->x[i][k]) || !isfinite(body->v[i][k]))
                    return false;
    }
    return true;
}

/// The paths of all shipped scenes; returns their number.
static inline int each_scene(void (*visit)(const char* path)) {
    char** path;
    const int count = scene_list(&path);
    for (int k = 0; k < count; k++) {
        visit(path[k]);
        free(path[k]);
    }
    free(path);
    return count;
}

#endif
