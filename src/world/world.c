#include "world/world.h"

#include <stdlib.h>
#include <string.h>

#include "base/crew.h"
#include "base/hash.h"
#include "base/memory.h"
#include "force/inflation.h"
#include "world/command.h"
#include "world/rest.h"

enum { SPLITS_MOST = 1024 }; ///< of a step that a method cannot solve
enum { PARTS_MOST = 4096 };  ///< of a step; what is left of it then is dropped: the ball waits

/// What is left of a step after its parts and is no part of its own. [1]
static const double rounding = 1e-12;

/// Floor, walls, and the balls that are there from the start.
static void open_collide(World* world) {
    const WorldDef* def = &world->def;
    Plane* plane = new_array(Plane, def->walls_count + 1);
    int planes = 0;
    if (def->floor)
        plane[planes++] = (Plane){.point = {0, *def->floor, 0, 0}, .normal = {0, 1, 0, 0}};
    for (unsigned w = 0; w < def->walls_count; w++) {
        const double *at = def->walls[w].at, *n = def->walls[w].normal;
        const double4 normal = {n[0], n[1], n[2], 0};
        plane[planes++] =
            (Plane){.point = {at[0], at[1], at[2], 0}, .normal = normal / dlength(normal)};
    }
    Body** body = new_array(Body*, world->balloon_count);
    const real4** before = new_array(const real4*, world->balloon_count);
    for (int b = 0; b < world->balloon_count; b++) {
        body[b] = &world->balloon[b].body;
        before[b] = world->balloon[b].last_v;
    }
    contacts_open(&world->contacts, def->contact, scene_gravity(def), plane, planes, body, before,
                  world->balloon_count);
    free(plane);
    free(body);
    free(before);

    for (unsigned s = 0; s < def->spheres_count; s++) {
        const SphereDef* ball = &def->spheres[s];
        const double none[3] = {0};
        const Sphere sphere =
            sphere_of(ball->position, ball->velocity ? ball->velocity : none, ball->radius,
                      ball->mass, ball->restitution, ball->friction);
        contacts_add(&world->contacts, &sphere);
    }
}

static void begin(World* world) {
    open_collide(world);
    world->step_count = 0;
    world->selected = ALL_BALLOONS;
    world->held = 0;
    world->substeps = 1;
    world->look = true;
    world->solvable = 1;
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
        good = balloon_open(&world->balloon[b], &world->def, world->method, (int)b, fault);
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
    contacts_close(&world->contacts);
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

/// Gas goes through pipes and leaks: what is lost on one side of a pipe arrives on the other.
static void flow(World* world, double h) {
    for (unsigned k = 0; k < world->def.pipes_count; k++) {
        const PipeDef* pipe = &world->def.pipes[k];
        if (world_time(world) < pipe->start)
            continue;
        Balloon* end[2] = {&world->balloon[(int)pipe->from], &world->balloon[(int)pipe->to]};
        const double energy =
            pipe->conductance * h *
            (inflation_pressure(&end[0]->body) - inflation_pressure(&end[1]->body));
        for (int e = 0; e < 2; e++) {
            Inflation* gas = &end[e]->body.inflation;
            const double change =
                (e ? 1 : -1) * energy / (gas->unit * gas->temperature * gas->first_volume);
            end[e]->hand += change;
            gas->amount += change;
        }
    }
    for (int b = 0; b < world->balloon_count; b++) {
        const InflationDef* inflation = world->balloon[b].def->inflation;
        if (inflation && inflation->leak > 0)
            balloon_leak(&world->balloon[b], h);
    }
}

/// A part of a step that each balloon takes by itself.
typedef struct Pass {
    World* world;
    double h;
} Pass;

/// Threads share the balloons where there are enough of them, else each balloon's own parts.
static void for_each(World* world, void (*part)(void* pass, int balloon), double h) {
    Pass pass = {world, h};
    if (world->balloon_count >= 2 * crew_threads())
        crew_run(part, &pass, world->balloon_count);
    else
        for (int b = 0; b < world->balloon_count; b++)
            part(&pass, b);
}

static void kick_balloon(void* self, int b) {
    const Pass* pass = self;
    const World* world = pass->world;
    Balloon* balloon = &world->balloon[b];
    balloon->solved = true;
    if (balloon->body.asleep)
        return;
    // velocities before: for what cannot be solved, and for contacts
    if (world->method->can_fail || world->contacts.sphere_count > 0)
        memcpy(balloon->last_v, balloon->body.v, (size_t)balloon->body.count * sizeof(real4));
    balloon->solved = world->method->kick(&balloon->body, balloon->room, pass->h, &balloon->effort);
}

static void say_factored(World* world, double h) {
    for (int b = 0; b < world->balloon_count; b++)
        if (!world->balloon[b].body.asleep && world->balloon[b].effort.factored)
            snprintf(world->notice, sizeof world->notice,
                     "balloon %d (%s): method '%s' factored its matrix for steps of %.3g s", b,
                     world->balloon[b].def->model, world->method->name, h);
}

/// Kick every balloon by h. Where a method could not solve its step, none is kicked, and that is
/// returned.
static int kick(World* world, double h) {
    for_each(world, kick_balloon, h);
    say_factored(world, h);
    int bad = 0;
    while (bad < world->balloon_count && world->balloon[bad].solved)
        bad++;
    if (bad == world->balloon_count)
        return NONE;
    for (int b = 0; b < world->balloon_count; b++)
        if (!world->balloon[b].body.asleep)
            memcpy(world->balloon[b].body.v, world->balloon[b].last_v,
                   (size_t)world->balloon[b].body.count * sizeof(real4));
    return bad;
}

static void correct_balloon(void* self, int b) {
    const Pass* pass = self;
    Balloon* balloon = &pass->world->balloon[b];
    if (!balloon->body.asleep)
        strain_limit_velocity(&balloon->correct, &balloon->body, pass->h);
}

static void drift_balloon(void* self, int b) {
    const Pass* pass = self;
    Balloon* balloon = &pass->world->balloon[b];
    if (balloon->body.asleep)
        return;
    pass->world->method->drift(&balloon->body, pass->h);
    volume_constraint_volume(&balloon->preserve, &balloon->body, pass->h);
}

/// As long as h, in one part, or in several where balls are near or a method cannot solve the
/// whole: kick, correction and contacts have their say on the velocities, then everything drifts.
static void advance(World* world, double h) {
    const double whole = h, shortest = h / SPLITS_MOST;
    for (int parts = 0; h > whole * rounding && parts < PARTS_MOST; parts++) {
        double pace = contacts_pace(&world->contacts, fmin(h, world->solvable * whole));
        for (int bad; (bad = kick(world, pace)) != NONE; pace /= 2) {
            if (pace < shortest) {
                guard_unsolved(world, bad, pace);
                return;
            }
            world->solvable = pace / 2 / whole;
        }
        for_each(world, correct_balloon, pace);
        const double drift = contacts_velocities(&world->contacts, pace);
        contacts_drift(&world->contacts, drift);
        for_each(world, drift_balloon, drift);
        contacts_penalty(&world->contacts, drift);
        world->drift = drift;
        h -= drift;
    }
    world->solvable = fmin(1, 2 * world->solvable);
    if (h > whole * rounding)
        snprintf(world->notice, sizeof world->notice,
                 "a ball and a skin need more than %d parts of step %ld: %.3g s of it are dropped",
                 PARTS_MOST, world->step_count, h);
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

    flow(world, world->step);
    rest_wake_changed(world);
    const double h = world->step / world->substeps;
    for (int part = 0; part < world->substeps && !world->blowup.halted; part++)
        advance(world, h);
    if (world->blowup.halted)
        return;
    world->step_count++;

    // a state that went bad is caught here, at its step
    guard_check(world);
    rest_look(world);
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
        if (world->def.rest > 0)
            hash = hash_bytes(hash, &body->still, sizeof body->still);
    }
    for (int s = 0; s < world->contacts.sphere_count; s++) {
        const Sphere* sphere = &world->contacts.sphere[s];
        hash = hash_bytes(hash, &sphere->x, 3 * sizeof(real));
        hash = hash_bytes(hash, &sphere->v, 3 * sizeof(real));
        hash = hash_bytes(hash, &sphere->spin, 3 * sizeof(real));
    }
    return hash;
}

void world_close(World* world) {
    contacts_close(&world->contacts);
    for (int b = 0; b < world->balloon_count; b++)
        balloon_close(&world->balloon[b]);
    free(world->balloon);
    scene_free(&world->def);
    *world = (World){0};
}
