#include "world/guard.h"

#include <string.h>

#include "body/extent.h"
#include "world/rest.h"
#include "world/world.h"

/// A particle that a fast ball has stretched away snaps back at several sizes a step and is well;
/// what explodes is past this a few steps later. [balloon's first size a drift]
static const double reach = 10;

/// Of its first volume: below it a gas has no room. [1]
static const double least_room = 1e-6;

static void halt(World* world, int balloon, int particle) {
    world->blowup.halted = true;
    world->blowup.balloon = balloon;
    world->blowup.particle = particle;
    world->blowup.step = world->step_count;
}

/// The smallest bound of all balloons; which one has it.
static double smallest_bound(const World* world, int* balloon) {
    double least = INFINITY;
    *balloon = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        if (world->balloon[b].body.asleep)
            continue;
        const double bound = method_bound(world->method, &world->balloon[b].body);
        if (bound < least) {
            least = bound;
            *balloon = b;
        }
    }
    return least;
}

static void refuse(World* world, int balloon, const char* remedy) {
    halt(world, balloon, NONE);
    snprintf(world->blowup.text, sizeof world->blowup.text,
             "balloon %d (%s): step %g s is above the largest stable one, %.3g s, at step %ld; %s",
             balloon, world->balloon[balloon].def->model, world->step, world->bound,
             world->step_count, remedy);
}

void guard_look(World* world) {
    world->look = false;
    if (world->def.guard == GUARD_OFF)
        return;

    int balloon;
    world->bound = smallest_bound(world, &balloon);
    if (world->bound <= 0) {
        halt(world, balloon, NONE);
        snprintf(world->blowup.text, sizeof world->blowup.text,
                 "balloon %d (%s): method '%s' is stable at no step, however small, where there is "
                 "no damping; give the balloon some, take another --method, or --guard off",
                 balloon, world->balloon[balloon].def->model, world->method->name);
        return;
    }
    const double parts = ceil(world->step / world->bound);
    if (world->def.guard == GUARD_STOP && parts > 1) {
        refuse(world, balloon, "take a smaller --step, or --guard split");
        return;
    }
    if (!(parts <= SUBSTEPS_MOST)) {
        refuse(world, balloon, "no sensible number of substeps makes up for that");
        return;
    }
    if ((int)parts > world->substeps)
        snprintf(world->notice, sizeof world->notice,
                 "step %g s is above the largest stable one, %.3g s: each is made in %d parts",
                 world->step, world->bound, (int)parts);
    world->substeps = parts > 1 ? (int)parts : 1;
}

void guard_keep(World* world) {
    for (int b = 0; b < world->balloon_count; b++) {
        Balloon* balloon = &world->balloon[b];
        const size_t bytes = (size_t)balloon->body.count * sizeof(real4);
        memcpy(balloon->good_x, balloon->body.x, bytes);
        memcpy(balloon->good_v, balloon->body.v, bytes);
        if (balloon->body.membrane.count > 0)
            memcpy(balloon->good_thickness, balloon->body.membrane.thickness,
                   (size_t)balloon->body.membrane.count * sizeof(real));
    }
    contacts_keep(&world->contacts);
    world->good_step = world->step_count;
}

static void put_back(World* world) {
    for (int b = 0; b < world->balloon_count; b++) {
        Balloon* balloon = &world->balloon[b];
        const size_t bytes = (size_t)balloon->body.count * sizeof(real4);
        memcpy(balloon->body.x, balloon->good_x, bytes);
        memcpy(balloon->body.v, balloon->good_v, bytes);
        if (balloon->body.membrane.count > 0)
            memcpy(balloon->body.membrane.thickness, balloon->good_thickness,
                   (size_t)balloon->body.membrane.count * sizeof(real));
    }
    contacts_put_back(&world->contacts);
    rest_wake_all(world);
}

void guard_unsolved(World* world, int balloon, double h) {
    halt(world, balloon, NONE);
    snprintf(
        world->blowup.text, sizeof world->blowup.text,
        "balloon %d (%s): method '%s' did not solve step %ld, at %.4g s, nor parts of it down to "
        "%.2g s; the state of step %ld is back",
        balloon, world->balloon[balloon].def->model, world->method->name, world->step_count,
        world_time(world), h, world->good_step);
    put_back(world);
}

/// A gas in no room: the skin has turned inside out or closed in on itself.
static bool has_no_room(const Body* body) {
    return body->inflation.law == INFLATE_GAS &&
           !(body->inflation.volume > least_room * body->inflation.first_volume);
}

/// The first particle whose position is not finite, or which moves by more than ten times the
/// balloon's first size in a drift against the balloon's mean; NONE when all is well.
static int bad_particle(const Body* body, double h) {
    const real most = (real)(reach * body->size / h);
    // where all are slower than this, none is so fast against the mean: 2 sqrt(3) < 4
    if (all_within(body->v, body->count, most / 4) &&
        all_within(body->x, body->count, real_sqrt(REAL_MOST) / 2))
        return NONE;

    real4 sum = {0, 0, 0, 0};
    for (int i = 0; i < body->count; i++)
        sum += body->v[i];
    const real4 mean = sum / (real)body->count;
    for (int i = 0; i < body->count; i++) {
        const real4 off = body->v[i] - mean, at = body->x[i];
        // written so that a NaN fails
        if (!(dot(off, off) <= most * most) || !(dot(at, at) < (real)INFINITY))
            return i;
    }
    return NONE;
}

static void halt_without_room(World* world, int b) {
    halt(world, b, NONE);
    snprintf(world->blowup.text, sizeof world->blowup.text,
             "balloon %d (%s): its gas has no room left in step %ld, at %.4g s: the volume is down "
             "to nothing; the state of step %ld is back",
             b, world->balloon[b].def->model, world->step_count, world_time(world),
             world->good_step);
    put_back(world);
}

/// The constraint on the sum asks nothing of single elements.
static void halt_inverted(World* world, int b, int element) {
    const Balloon* balloon = &world->balloon[b];
    const int *corner = balloon->body.membrane.corner[element], *loaded = balloon->mesh.loaded;
    halt(world, b, loaded[corner[0]]);
    snprintf(world->blowup.text, sizeof world->blowup.text,
             "balloon %d (%s): the element of particles %d, %d and %d has no thickness left in "
             "step %ld, at %.4g s, for 'volume: global' keeps the sum alone; the state of step "
             "%ld is back",
             b, balloon->def->model, loaded[corner[0]], loaded[corner[1]], loaded[corner[2]],
             world->step_count, world_time(world), world->good_step);
    put_back(world);
}

void guard_check(World* world) {
    const double h = world->drift;
    for (int b = 0; b < world->balloon_count; b++) {
        const Balloon* balloon = &world->balloon[b];
        if (balloon->body.asleep)
            continue;
        if (has_no_room(&balloon->body)) {
            halt_without_room(world, b);
            return;
        }
        if (balloon->volume_constraint.inverted != NONE) {
            halt_inverted(world, b, balloon->volume_constraint.inverted);
            return;
        }
        const int bad = bad_particle(&balloon->body, h);
        if (bad == NONE)
            continue;
        halt(world, b, balloon->mesh.loaded[bad]);
        if (world->def.guard == GUARD_OFF) { // nobody has looked at the bound
            int which;
            put_back(world);
            world->bound = smallest_bound(world, &which);
        }
        snprintf(world->blowup.text, sizeof world->blowup.text,
                 "balloon %d (%s) went bad in step %ld, at %.4g s: particle %d %s; the step is "
                 "%.3g s, the largest stable one %.3g s; the state of step %ld is back",
                 b, balloon->def->model, world->step_count, world_time(world),
                 balloon->mesh.loaded[bad],
                 "is not finite or went ten times the balloon's size in one step", h, world->bound,
                 world->good_step);
        put_back(world);
        return;
    }
    const int ball = contacts_bad(&world->contacts);
    if (ball != NONE) {
        halt(world, NONE, NONE);
        snprintf(
            world->blowup.text, sizeof world->blowup.text,
            "ball %d went bad in step %ld, at %.4g s: it is nowhere any more; the state of step "
            "%ld is back",
            ball, world->step_count, world_time(world), world->good_step);
        put_back(world);
        return;
    }
    if (world->step_count % GUARD_INTERVAL == 0)
        guard_keep(world);
}
