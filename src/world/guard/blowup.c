#include "world/guard/blowup.h"

#include <string.h>

#include "body/extent.h"
#include "mesh/measure.h"
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
    joints_keep(&world->system.joints);
    world->good_step = world->step_count;
    world->watch.touched = false;
}

void blowup_take_back(World* world) {
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
    joints_put_back(&world->system.joints);
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
    blowup_take_back(world);
}

/// What is bad about a state.
typedef enum Cause {
    CAUSE_NONE,
    CAUSE_NOT_FINITE, ///< a particle's position or velocity
    CAUSE_FAST,       ///< a particle moves too far in a drift
    CAUSE_INVERTED,   ///< a gas has a volume below 0: the skin is inside out
    CAUSE_EMPTY,      ///< a gas has lost its volume
    CAUSE_FLAT,       ///< an element has lost its thickness
    CAUSE_BALL        ///< a ball is not finite
} Cause;

/// Where it is bad, and by how much.
typedef struct Bad {
    Cause cause;
    int balloon; ///< NONE: a ball
    int number;  ///< of the particle, the element or the ball; NONE: the whole balloon
    double size; ///< way in a drift over the balloon's size, or volume over the first [1]
} Bad;

static real4 mean_velocity(const Body* body) {
    real4 sum = {0, 0, 0, 0};
    for (int i = 0; i < body->count; i++)
        sum += body->v[i];
    return sum / (real)body->count;
}

/// The first particle whose position is not finite, or which moves by more than way_max in a drift
/// of length h, relative to the balloon's mean velocity.
static Bad bad_particle(const Body* body, double h) {
    const real speed_max = (real)(way_max * body->size / h);
    // components below 1/4 of it keep the relative speed below it: 2 sqrt(3) < 4
    if (all_within(body->v, body->count, speed_max / 4) &&
        all_within(body->x, body->count, real_sqrt(REAL_MAX) / 2))
        return (Bad){0};

    const real4 mean = mean_velocity(body);
    for (int i = 0; i < body->count; i++) {
        const real4 relative = body->v[i] - mean, x = body->x[i];
        // written so that a NaN fails
        if (!(dot(x, x) < (real)INFINITY) || !(dot(relative, relative) < (real)INFINITY))
            return (Bad){CAUSE_NOT_FINITE, NONE, i, 0};
        if (!(dot(relative, relative) <= speed_max * speed_max))
            return (Bad){CAUSE_FAST, NONE, i, (double)length(relative) * h / body->size};
    }
    return (Bad){0};
}

/// Whether a gas has lost its volume: the skin has turned inside out or folded onto itself.
static Bad bad_volume(const Body* body) {
    const Inflation* gas = &body->inflation;
    if (gas->law != INFLATE_GAS || gas->volume > volume_share_min * gas->first_volume)
        return (Bad){0};
    const double share = gas->volume / gas->first_volume;
    return (Bad){share < -volume_share_min ? CAUSE_INVERTED : CAUSE_EMPTY, NONE, NONE, share};
}

/// An explosion also loses the volume: its particles come first.
static Bad bad_balloon(const Balloon* balloon, double h) {
    const Bad particle = bad_particle(&balloon->body, h);
    if (particle.cause)
        return particle;
    const Bad volume = bad_volume(&balloon->body);
    if (volume.cause)
        return volume;
    // the constraint on the total volume of the rubber does not limit that of a single element
    const int inverted = balloon->volume_constraint.inverted;
    return inverted == NONE ? (Bad){0} : (Bad){CAUSE_FLAT, NONE, inverted, 0};
}

static Bad find_bad(const World* world) {
    for (int b = 0; b < world->balloon_count; b++) {
        const Balloon* balloon = &world->balloon[b];
        Bad bad = balloon->body.asleep ? (Bad){0} : bad_balloon(balloon, world->kicked);
        bad.balloon = b;
        if (bad.cause)
            return bad;
    }
    const int ball = contacts_bad(&world->contacts);
    return ball == NONE ? (Bad){0} : (Bad){CAUSE_BALL, NONE, ball, 0};
}

bool blowup_is_bad(const World* world) {
    return find_bad(world).cause != CAUSE_NONE;
}

/// The cause, as measured.
static int say_cause(const World* world, const Bad* bad, char* text, size_t size) {
    const Balloon* balloon = bad->balloon == NONE ? NULL : &world->balloon[bad->balloon];
    const int* loaded = balloon ? balloon->mesh.loaded : NULL;
    const int* corner =
        bad->cause == CAUSE_FLAT ? balloon->body.membrane.corner[bad->number] : NULL;
    switch (bad->cause) {
        case CAUSE_NOT_FINITE:
            return snprintf(text, size, "it exploded: particle %d is not finite",
                            loaded[bad->number]);
        case CAUSE_FAST:
            return snprintf(text, size,
                            "it exploded: particle %d moved %.3g times the balloon's size at once",
                            loaded[bad->number], bad->size);
        case CAUSE_INVERTED:
            return snprintf(text, size, "it is inside out: its volume is %.3g of the first",
                            bad->size);
        case CAUSE_EMPTY:
            return snprintf(text, size, "it is empty: its volume is %.3g of the first", bad->size);
        case CAUSE_FLAT:
            return snprintf(text, size,
                            "the element of particles %d, %d and %d has no thickness left, for "
                            "'volume: global' keeps the sum alone",
                            loaded[corner[0]], loaded[corner[1]], loaded[corner[2]]);
        default:
            return snprintf(text, size, "its position is not finite");
    }
}

/// The state before, which is back: how full the balloon was, and whether its step was stable.
static int say_state(World* world, int b, char* text, size_t size) {
    const Body* body = &world->balloon[b].body;
    int used = 0;
    if (body->inflation.law == INFLATE_GAS)
        used = snprintf(text, size, "; before, its volume was %.3g of the first",
                        measure_volume(body->mesh, body->x) / body->inflation.first_volume);
    if (world->guard.mode == GUARD_OFF) { // the bound has not been computed yet
        int body_of_bound;
        world->guard.bound = guard_bound(world->method, &world->system, &body_of_bound);
    }
    if (world->method->implicit)
        return used;
    return used + snprintf(text + used, size - (size_t)used,
                           "; the step is %.3g s, %s the largest stable one, %.3g s", world->kicked,
                           world->kicked > world->guard.bound ? "above" : "within",
                           world->guard.bound);
}

/// Name the bad state, restore the last good one and halt.
static void halt_bad(World* world, const Bad* bad) {
    Blowup* blowup = &world->blowup;
    const bool ball = bad->balloon == NONE, particle = bad->cause <= CAUSE_FAST;
    halt(world, bad->balloon,
         particle && !ball ? world->balloon[bad->balloon].mesh.loaded[bad->number] : NONE);
    char cause[160], before[160] = "", name[80];
    say_cause(world, bad, cause, sizeof cause);
    blowup_take_back(world);
    if (ball)
        snprintf(name, sizeof name, "ball %d", bad->number);
    else {
        snprintf(name, sizeof name, "balloon %d (%.60s)", bad->balloon,
                 world->balloon[bad->balloon].def->model);
        say_state(world, bad->balloon, before, sizeof before);
    }
    snprintf(blowup->text, sizeof blowup->text,
             "%s went bad in step %ld, at %.4g s: %s%s; the state of step %ld is back", name,
             world->step_count, world_time(world), cause, before, world->good_step);
}

void blowup_gained(World* world, double gain, double turnover) {
    halt(world, NONE, NONE);
    snprintf(
        world->blowup.text, sizeof world->blowup.text,
        "the scene went bad in step %ld, at %.4g s: it gained %.3g J beside %.3g J that the step "
        "converted, in %d substeps of which each was stable when it began; the state of step "
        "%ld is back",
        world->step_count, world_time(world), gain, turnover, world->guard.substeps,
        world->good_step);
    blowup_take_back(world);
}

void blowup_check(World* world) {
    const Bad bad = find_bad(world);
    if (bad.cause) {
        if (!energy_watch_goes_back(world))
            halt_bad(world, &bad);
    } else if (world->step_count % GUARD_INTERVAL == 0)
        blowup_save_state(world);
}
