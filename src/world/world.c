#include "world/world.h"

#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "base/memory.h"
#include "world/command.h"

static void begin(World* world) {
    world->step_count = 0;
    world->selected = ALL_BALLOONS;
    world->held = 0;
    world->substeps = 1;
    world->look = true;
    world->blowup = (Blowup){0};
    guard_keep(world);
}

bool world_open(World* world, WorldDef* def, Fault* fault) {
    *world = (World){.def = *def, .step = def->step};
    *def = (WorldDef){0};
    world->method = world->def.method ? method_find(world->def.method) : method_table[0];
    world->balloon = new_array(Balloon, world->def.balloons_count);

    bool good = true;
    for (unsigned b = 0; good && b < world->def.balloons_count; b++) {
        good = balloon_open(&world->balloon[b], &world->def, (int)b, fault);
        world->balloon_count++;
    }
    if (!good) {
        world_close(world);
        return false;
    }
    begin(world);
    return true;
}

void world_reset(World* world) {
    for (int b = 0; b < world->balloon_count; b++)
        balloon_reset(&world->balloon[b], &world->def);
    begin(world);
}

/// What the scene's filling and the held keys make of the amounts at the end of this step.
static void take_hand(World* world) {
    for (int b = 0; b < world->balloon_count; b++)
        balloon_fill(&world->balloon[b], (double)(world->step_count + 1) * world->step);
    for (int k = 0; k < command_count; k++)
        if (command_table[k].hold && (world->held >> k & 1))
            command_table[k].hold(world, world->step);
}

void world_step(World* world) {
    world->clock++;
    if (world->blowup.halted)
        return;
    take_hand(world);

    // hold the step against the stability bound, which moves with the pressure
    if (world->look || world->step_count % GUARD_INTERVAL == 0)
        guard_look(world);
    if (world->blowup.halted)
        return;

    // kick: velocities under the forces; correction has its say on them; drift: positions
    const double h = world->step / world->substeps;
    for (int b = 0; b < world->balloon_count; b++) {
        Balloon* balloon = &world->balloon[b];
        for (int part = 0; part < world->substeps; part++) {
            world->method->kick(&balloon->body, h);
            correct_velocity(&balloon->correct, &balloon->body, h);
            body_drift(&balloon->body, h);
        }
    }
    world->step_count++;

    // a state that went bad is caught here, at its step
    guard_check(world);
}

uint64_t world_hash(const World* world) {
    uint64_t hash = HASH_START;
    for (int b = 0; b < world->balloon_count; b++) {
        const Body* body = &world->balloon[b].body;
        for (int k = 0; k < body->count; k++) {
            const int i = body->mesh->inside[k];
            hash = hash_bytes(hash, &body->x[i], 3 * sizeof(real));
            hash = hash_bytes(hash, &body->v[i], 3 * sizeof(real));
        }
    }
    return hash;
}

void world_close(World* world) {
    for (int b = 0; b < world->balloon_count; b++)
        balloon_close(&world->balloon[b]);
    free(world->balloon);
    scene_free(&world->def);
    *world = (World){0};
}
