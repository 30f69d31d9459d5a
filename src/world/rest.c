#include "world/rest.h"

#include <string.h>

#include "world/world.h"

static const double still_seconds = 0.5; ///< [s] time at rest before it sleeps

void rest_wake_changed(World* world) {
    for (Balloon* b = world->balloon; b < world->balloon + world->balloon_count; b++)
        if (b->body.asleep && b->body.inflation.amount != b->sleep_amount)
            body_wake(&b->body);
}

void rest_wake_all(World* world) {
    for (int b = 0; b < world->balloon_count; b++)
        body_wake(&world->balloon[b].body);
}

/// Written so that a NaN is not still.
static bool is_still(const Body* body, double rest) {
    if (body->joined_w2 > 0) // the other end of a string may move
        return false;
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

/// Whether a balloon and all in its island have been still for long enough.
static bool may_sleep(const World* world, int balloon) {
    for (int b = 0; b < world->balloon_count; b++)
        if (contacts_join(&world->contacts, balloon, b) &&
            world->balloon[b].body.still * GUARD_INTERVAL * world->step < still_seconds)
            return false;
    return true;
}

void rest_check(World* world) {
    if (world->def.sleep_threshold == 0 || world->step_count % GUARD_INTERVAL != 0)
        return;
    for (Balloon* b = world->balloon; b < world->balloon + world->balloon_count; b++)
        if (!b->body.asleep)
            b->body.still = is_still(&b->body, world->def.sleep_threshold) ? b->body.still + 1 : 0;
    for (int b = 0; b < world->balloon_count; b++)
        if (!world->balloon[b].body.asleep && may_sleep(world, b))
            sleep(&world->balloon[b]);
}
