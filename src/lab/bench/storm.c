#include "lab/bench/storm.h"

#include "contact/triangle_path.h"

enum { SETS = 5 };

static int winding_around(const World* world, int s) {
    const Balloon* balloon = &world->balloon[0];
    return (int)lround(
        winding_number(&balloon->mesh, balloon->body.x, to_double4(world->contacts.sphere[s].x)));
}

bool storm_open(Storm* storm, uint64_t seed, Fault* fault) {
    *storm = (Storm){.random = {seed}};
    char step[64];
    snprintf(step, sizeof step, "step=%.17g", 1.0 / STORM_RATE);
    const SceneSet set[SETS] = {
        {step},
        {"floor=-3"},
        {"balloons.0.strings=[]"},
        {"balloons.0.helium={base: 0}"},
        {"balloons.0.inflation={law: area, amount: 3, rate: 8, min: 0.2, max: 25}"}};
    WorldDef def;
    return scene_load("cube-sphere:8", set, SETS, &def, fault) &&
           world_open(&storm->world, &def, fault);
}

static bool throw_one(Storm* storm, Fault* fault) {
    World* world = &storm->world;
    Random* random = &storm->random;
    Event event = {.step = world->clock, .kind = EVENT_THROW};
    double4 d = {0};
    for (int k = 0; k < 3; k++)
        d[k] = 2 * random_next(random) - 1;
    d[1] = fabs(d[1]);
    d /= dlength(d);
    const double speed = pow(10, 2.3 * random_next(random));
    const double radius = 0.03 * pow(10, 1.2 * random_next(random));
    const Body* body = &world->balloon[0].body;
    double4 middle = {0};
    for (int i = 0; i < body->count; i++)
        middle += to_double4(body->x[i]) / body->count;
    for (int k = 0; k < 3; k++) {
        event.thrown[k] = middle[k] + (4 + radius) * d[k];
        event.thrown[3 + k] = speed * (0.2 * (random_next(random) - 0.5) - d[k]);
    }
    const double balloon = (double)body->mass[0] * body->count;
    event.thrown[6] = balloon * pow(10, -1 + 2 * random_next(random));
    event.thrown[7] = radius;
    if (!world_event(world, &event, fault))
        return false;
    const int s = world->contacts.sphere_count - 1;
    storm->winding[s] = winding_around(world, s);
    return true;
}

static bool press(World* world, const char* key, const char* state, Fault* fault) {
    Event event = {.step = world->clock, .kind = EVENT_KEY};
    snprintf(event.name, sizeof event.name, "%s", key);
    snprintf(event.value, sizeof event.value, "%s", state);
    return world_event(world, &event, fault);
}

bool storm_step(Storm* storm, Fault* fault) {
    World* world = &storm->world;
    const long n = world->clock;
    if (n % STORM_CLEAR == 0 && !press(world, "clear", "down", fault))
        return false;
    if (n % STORM_THROW == 0 && !throw_one(storm, fault))
        return false;
    if (n % (2 * STORM_KEY) == 0) {
        const char* key = random_next(&storm->random) < 0.5 ? "inflate" : "deflate";
        if (!press(world, key, "down", fault))
            return false;
    }
    if (n % (2 * STORM_KEY) == STORM_KEY &&
        (!press(world, "inflate", "up", fault) || !press(world, "deflate", "up", fault)))
        return false;
    world_step(world);
    return true;
}

int storm_astray(const Storm* storm) {
    int astray = 0;
    for (int s = 0; s < storm->world.contacts.sphere_count; s++)
        astray += winding_around(&storm->world, s) != storm->winding[s];
    return astray;
}

void storm_close(Storm* storm) {
    world_close(&storm->world);
}
