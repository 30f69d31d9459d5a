#include "world/rest.h"

#include <string.h>

#include "world/world.h"

static const double still_seconds = 0.5; ///< [s] time at rest before it sleeps

void rest_wake_changed(World* world) {
    for (int b = 0; b < world->balloon_count; b++) {
        Balloon* balloon = &world->balloon[b];
        if (balloon->body.asleep && balloon->body.inflation.amount != balloon->sleep_amount)
            body_wake(&balloon->body);
    }
}

void rest_wake_all(World* world) {
    for (int b = 0; b < world->balloon_count; b++)
        body_wake(&world->balloon[b].body);
}

/// Written so that a NaN is not still.
static bool is_still(const Body* body, double rest) {
    const real speed_max = (real)(rest * body->size);
    for (int i = 0; i < body->count; i++)
        if (!(dot(body->v[i], body->v[i]) < speed_max * speed_max))
            return false;
    return true;
}

static void sleep(Balloon* balloon) {
    Body* body = &balloon->body;
    body->asleep = true;
    memset(body->v, 0, (size_t)body->count * sizeof *body->v);
    memset(balloon->v_start, 0, (size_t)body->count * sizeof *balloon->v_start);
    balloon->stats = (SolveStats){0};
    balloon->sleep_amount = body->inflation.amount;
}

void rest_check(World* world) {
    if (world->def.sleep_threshold == 0 || world->step_count % GUARD_INTERVAL != 0)
        return;
    for (int b = 0; b < world->balloon_count; b++) {
        Body* body = &world->balloon[b].body;
        if (body->asleep)
            continue;
        body->still = is_still(body, world->def.sleep_threshold) ? body->still + 1 : 0;
        if (body->still * GUARD_INTERVAL * world->step >= still_seconds)
            sleep(&world->balloon[b]);
    }
}
