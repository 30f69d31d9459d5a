#include "world/blowup.h"

#include <string.h>

#include "body/extent.h"
#include "world/rest.h"
#include "world/world.h"

/// Longest way of a particle in a drift [of the balloon's first size]. A particle that a fast ball
/// has pulled away snaps back by several sizes in a step; a state that explodes exceeds this limit
/// within a few steps.
static const double way_max = 10;

/// Smallest volume of a gas. [of its first volume]
static const double volume_share_min = 1e-6;

static void halt(World* world, int balloon, int particle) {
    world->blowup.halted = true;
    world->blowup.balloon = balloon;
    world->blowup.particle = particle;
    world->blowup.step = world->step_count;
}

void blowup_report(World* world, GuardVerdict verdict, int b) {
    if (verdict == VERDICT_GOOD)
        return;
    if (verdict == VERDICT_SPLIT) {
        snprintf(world->notice, sizeof world->notice,
                 "step %g s is above the largest stable one, %.3g s: each is made in %d parts",
                 world->step, world->guard.bound, world->guard.substeps);
        return;
    }
    halt(world, b, NONE);
    const char* model = world->balloon[b].def->model;
    if (verdict == VERDICT_NEVER_STABLE)
        snprintf(world->blowup.text, sizeof world->blowup.text,
                 "balloon %d (%s): method '%s' is stable at no step, however small, where there is "
                 "no damping; give the balloon some, take another --method, or --guard off",
                 b, model, world->method->name);
    else
        snprintf(
            world->blowup.text, sizeof world->blowup.text,
            "balloon %d (%s): step %g s is above the largest stable one, %.3g s, at step %ld; %s",
            b, model, world->step, world->guard.bound, world->step_count,
            verdict == VERDICT_TOO_LONG ? "take a smaller --step, or --guard split"
                                        : "no sensible number of substeps makes up for that");
}

void blowup_save_state(World* world) {
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

static void restore_state(World* world) {
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

void blowup_unsolved(World* world, int balloon, double h) {
    halt(world, balloon, NONE);
    snprintf(
        world->blowup.text, sizeof world->blowup.text,
        "balloon %d (%s): method '%s' did not solve step %ld, at %.4g s, nor parts of it down to "
        "%.2g s; the state of step %ld is back",
        balloon, world->balloon[balloon].def->model, world->method->name, world->step_count,
        world_time(world), h, world->good_step);
    restore_state(world);
}

/// Whether a gas has lost its volume: the skin has turned inside out or folded onto itself.
static bool has_lost_volume(const Body* body) {
    return body->inflation.law == INFLATE_GAS &&
           !(body->inflation.volume > volume_share_min * body->inflation.first_volume);
}

/// The first particle whose position is not finite, or which moves by more than way_max in a drift
/// of length h, relative to the balloon's mean velocity; NONE where there is none.
static int bad_particle(const Body* body, double h) {
    const real speed_max = (real)(way_max * body->size / h);
    // components below 1/4 of it keep the relative speed below it: 2 sqrt(3) < 4
    if (all_within(body->v, body->count, speed_max / 4) &&
        all_within(body->x, body->count, real_sqrt(REAL_MAX) / 2))
        return NONE;

    real4 sum = {0, 0, 0, 0};
    for (int i = 0; i < body->count; i++)
        sum += body->v[i];
    const real4 mean = sum / (real)body->count;
    for (int i = 0; i < body->count; i++) {
        const real4 relative = body->v[i] - mean, x = body->x[i];
        // written so that a NaN fails
        if (!(dot(relative, relative) <= speed_max * speed_max) || !(dot(x, x) < (real)INFINITY))
            return i;
    }
    return NONE;
}

static void halt_without_volume(World* world, int b) {
    halt(world, b, NONE);
    snprintf(world->blowup.text, sizeof world->blowup.text,
             "balloon %d (%s): its gas has no room left in step %ld, at %.4g s: the volume is down "
             "to nothing; the state of step %ld is back",
             b, world->balloon[b].def->model, world->step_count, world_time(world),
             world->good_step);
    restore_state(world);
}

/// The constraint on the total volume of the rubber does not limit that of a single element.
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
    restore_state(world);
}

void blowup_check(World* world) {
    const double h = world->drift;
    for (int b = 0; b < world->balloon_count; b++) {
        const Balloon* balloon = &world->balloon[b];
        if (balloon->body.asleep)
            continue;
        if (has_lost_volume(&balloon->body)) {
            halt_without_volume(world, b);
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
        if (world->guard.mode == GUARD_OFF) { // the bound has not been computed yet
            int body;
            restore_state(world);
            world->guard.bound = guard_bound(world->method, &world->system, &body);
        }
        snprintf(world->blowup.text, sizeof world->blowup.text,
                 "balloon %d (%s) went bad in step %ld, at %.4g s: particle %d %s; the step is "
                 "%.3g s, the largest stable one %.3g s; the state of step %ld is back",
                 b, balloon->def->model, world->step_count, world_time(world),
                 balloon->mesh.loaded[bad],
                 "is not finite or went ten times the balloon's size in one step", h,
                 world->guard.bound, world->good_step);
        restore_state(world);
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
        restore_state(world);
        return;
    }
    if (world->step_count % GUARD_INTERVAL == 0)
        blowup_save_state(world);
}
