#include "world/world.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/crew.h"
#include "base/hash.h"
#include "base/interrupt.h"
#include "base/memory.h"
#include "contact/reaction.h"
#include "contact/skins/crossings.h"
#include "world/gas_flow.h"
#include "world/knots/knots.h"
#include "world/rest.h"
#include "world/things/balls.h"
#include "world/things/things.h"

enum { SPLITS_MAX = 1024 };    ///< a method that cannot solve 1/1024 of a step fails
enum { SPLITS_SLOW = 64 };     ///< a step made in as many parts is said to be slow
enum { SUBSTEPS_NEAR = 4096 }; ///< most substeps near balls; the rest of the step is dropped

/// A remainder of a step that is only rounding. [of the step]
static const double rounding = 1e-12;

/// Floor, walls, and the balls of the scene.
static void open_contacts(World* world) {
    const WorldDef* def = &world->def;
    Plane* plane = new_array(Plane, def->walls_count + 1);
    int planes = 0;
    if (def->floor)
        plane[planes++] = (Plane){.point = {0, *def->floor, 0, 0},
                                  .normal = {0, 1, 0, 0},
                                  .friction = (real)def->floor_friction};
    for (unsigned w = 0; w < def->walls_count; w++) {
        const double *point = def->walls[w].at, *n = def->walls[w].normal;
        const double4 normal = {n[0], n[1], n[2], 0};
        plane[planes++] = (Plane){.point = {point[0], point[1], point[2], 0},
                                  .normal = normal / dlength(normal),
                                  .friction = (real)def->walls[w].friction};
    }
    contacts_open(&world->contacts, def->contact, scene_gravity(def), plane, planes, def->contacts,
                  world->system.body, (const real4* const*)world->system.v_start,
                  world->balloon_count);
    free(plane);
    things_begin(world);
    balls_begin(world);
}

/// Say which skins that may touch cross or meet at the start: few scenes mean that.
static void notice_crossings(World* world) {
    Crossings found = crossings_find(&world->contacts, true);
    bool any = found.count > 0;
    if (!any) {
        skin_pairs_begin(&world->contacts);
        any = crossings_left_out(&world->contacts, found.skin);
        skin_pairs_close(&world->contacts); // the first step begins with the positions of its time
    }
    if (any && found.skin[1] < world->balloon_count)
        crossings_say(&found, world->balloon[found.skin[0]].def->model,
                      world->balloon[found.skin[1]].def->model, world->notice,
                      sizeof world->notice);
}

/// The balloons as the system that the method steps.
static void open_system(World* world) {
    System* system = &world->system;
    system_open(system, world->balloon_count);
    for (int b = 0; b < world->balloon_count; b++) {
        Balloon* balloon = &world->balloon[b];
        system->body[b] = &balloon->body;
        system->strain_limit[b] = &balloon->strain_limit;
        system->workspace[b] = balloon->workspace;
        system->stats[b] = &balloon->stats;
        system->v_start[b] = balloon->v_start;
    }
}

static void begin(World* world) {
    open_system(world);
    knots_begin(world);
    open_contacts(world);
    world->step_count = 0;
    world->selected = ALL_BALLOONS;
    world->held = 0;
    world->guard = guard_new(world->def.guard);
    world->watch = (EnergyWatch){0};
    world->solvable = 1;
    world->blowup = (Blowup){0};
    blowup_save_state(world);
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
    if (!good || !things_open(world, fault) || !knots_open(world, fault)) {
        world_close(world);
        return false;
    }
    begin(world);
    notice_crossings(world);
    return true;
}

void world_reset(World* world) {
    contacts_close(&world->contacts);
    system_close(&world->system);
    for (int b = 0; b < world->balloon_count; b++)
        balloon_reset(&world->balloon[b], &world->def);
    begin(world);
}

static void notice_factored(World* world, double h) {
    for (int b = 0; b < world->balloon_count; b++)
        if (!world->balloon[b].body.asleep && world->balloon[b].stats.factored)
            snprintf(world->notice, sizeof world->notice,
                     "balloon %d (%s): method '%s' factored its matrix for steps of %.3g s", b,
                     world->balloon[b].def->model, world->method->name, h);
}

/// What the tasks of a drift share.
typedef struct Drift {
    World* world;
    double h;
} Drift;

static void drift_balloon(void* self, int b) {
    const Drift* drift = self;
    Balloon* balloon = &drift->world->balloon[b];
    if (balloon->body.asleep)
        return;
    drift->world->method->drift(&balloon->body, drift->h);
    contacts_place(&drift->world->contacts, b);
    volume_constraint_volume(&balloon->volume_constraint, &balloon->body, drift->h);
}

static void drift(World* world, double h) {
    contacts_drift(&world->contacts, h);
    joints_drift(&world->system.joints, h);
    system_for_each(&world->system, drift_balloon, &(Drift){world, h});
    contacts_penalty(&world->contacts, h);
}

/// Whether the world has halted, or a run that was asked to end leaves its step: some take minutes.
static bool is_over(const World* world) {
    return world->blowup.halted || interrupt_signal();
}

/// Whether the equation of the kick that failed contains contacts.
static bool contains_contacts(const World* world) {
    return world->method->kick_group && world->contacts.contact_count > 0;
}

/// The longest kick, at most h, for an equation without its contacts, which then change the velocities.
/// At that length an explicit step is stable; a drift by other velocities than those of a longer solve
/// would stretch what is stiff, and gain energy. [s]
static double longest_without_contacts(const World* world, double h) {
    int body;
    return contains_contacts(world) ? fmin(h, guard_bound(&method_euler, &world->system, &body))
                                    : h;
}

/// Kick by h, or by the first half, quarter … of h that the method can solve. Returns the length of
/// the kick, or 0 where the method cannot solve the shortest substep. *drift: the longest drift until
/// contacts must be found again; becomes how much of it may be drifted.
static double kick(World* world, double h, double whole, double* drift) {
    const double safe = *drift, first = h;
    while (!world->method->kick(world->method, &world->system, &world->contacts, h, drift)) {
        notice_factored(world, h);
        if (interrupt_signal())
            return 0;
        const int unsolved = world->system.unsolved_in_row;
        const bool may_leave_out = contains_contacts(world) && unsolved <= UNSOLVED_MAX + 1;
        if (h < whole / SPLITS_MAX && !may_leave_out) {
            blowup_unsolved(world, world->system.unsolved, h);
            return 0;
        }
        const bool leaves_out = unsolved == UNSOLVED_MAX + 1;
        h = leaves_out ? longest_without_contacts(world, first) : h / 2;
        *drift = fmin(safe, h);
        world->solvable = h / whole;
        if (leaves_out && contains_contacts(world))
            world->solvable = longest_without_contacts(world, whole) / whole;
        if (h * SPLITS_SLOW <= whole && 2 * h * SPLITS_SLOW > whole)
            snprintf(world->notice, sizeof world->notice,
                     "method '%s' does not solve step %ld in less than %d parts, which is slow",
                     world->method->name, world->step_count, SPLITS_SLOW);
    }
    notice_factored(world, h);
    world->kicked = h;
    return h;
}

/// By the corrections of its velocities that are to be expected. [s]
static double longest_substep(const World* world) {
    const bool corrected = world->contacts.contact_count > 0 || guard_limits_strain(&world->system);
    return corrected ? world->corrected : (double)INFINITY;
}

/// Drift for as long as contacts allow, at most h, in parts with velocities solved anew for each
/// where skins touch; *part: the first. Returns the length of all.
static double drift_in_parts(World* world, double h, double part, int* parts) {
    double length = part;
    drift(world, part);
    while (contacts_in_parts(&world->contacts) && h - length > h * rounding &&
           (*parts)++ < SUBSTEPS_NEAR && !is_over(world)) {
        part = contacts_velocities_again(&world->contacts, h - length);
        drift(world, part);
        length += part;
    }
    return length;
}

/// Advance by h, in several drifts where balls are near. Contacts are found and solved anew for each,
/// each of a safe length. An implicit method kicks before each, in as many substeps as it can solve.
/// An explicit one kicks once, by h: kicks of changing lengths gain energy (guard.h).
static void advance(World* world, double h) {
    const double whole = h;
    const bool kicks_once = !world->method->implicit;
    world->system.unsolved_in_row = 0;
    for (int parts = 0; h > whole * rounding && parts < SUBSTEPS_NEAR; parts++) {
        const double longest = fmin(longest_substep(world), world->solvable * whole);
        world->system.whole = fmin(whole, longest);
        double safe = contacts_safe_step(&world->contacts, fmin(h, longest)), part = safe;
        if (kicks_once && parts > 0)
            part = contacts_velocities(&world->contacts, safe);
        else
            safe = fmin(safe, kick(world, kicks_once ? whole : safe, whole, &part));
        if (is_over(world))
            return;
        h -= drift_in_parts(world, safe, part, &parts);
    }
    world->solvable = fmin(1, 2 * world->solvable);
    if (h > whole * rounding)
        snprintf(world->notice, sizeof world->notice,
                 "a ball and a skin need more than %d parts of step %ld: %.3g s of it are dropped",
                 SUBSTEPS_NEAR, world->step_count, h);
}

static void update_guard(World* world) {
    int body;
    const GuardVerdict verdict =
        guard_update(&world->guard, world->method, &world->system, world->step, &body);
    world->contacts.woke = false;
    blowup_report(world, verdict, body);
}

/// The step in equal substeps; where the bound falls meanwhile, the rest of it in shorter ones.
static void make_substeps(World* world) {
    StepGuard* guard = &world->guard;
    reaction_clear(&world->contacts);
    int parts = guard->substeps, remaining = parts;
    double h = world->step / parts;
    while (remaining > 0 && !is_over(world)) {
        gas_flow_reach(world, remaining > 1 ? 1 - (remaining - 1) * h / world->step : 1);
        advance(world, h);
        guard->since_look++;
        remaining--;
        const bool due = guard_due_within(guard) || world->contacts.woke;
        if (is_over(world) || remaining == 0 || !due)
            continue;
        if (blowup_is_bad(world)) // it has no bound, and is taken back or named below
            return;
        update_guard(world);
        if (guard->substeps > parts) {
            parts = guard->substeps;
            const double rest = remaining * h;
            remaining = (int)ceil(rest / (world->step / parts) - rounding);
            h = rest / remaining;
        }
    }
}

/// One step, counted where it is made.
static void make_step(World* world) {
    gas_flow_fill(world);

    // compare the step with the stability bound, which changes with the state
    if (guard_due(&world->guard, world->step_count) || world->contacts.woke)
        update_guard(world);
    if (world->blowup.halted)
        return;

    gas_flow_through(world);
    rest_wake_changed(world);
    energy_watch_start(world);
    world->corrected = guard_bound_corrected(&world->guard, world->method, &world->system);
    do
        make_substeps(world);
    while (!is_over(world) && energy_watch_takes_back(world));
    if (is_over(world))
        return;
    things_notice(world);
    world->step_count++;
}

void world_step(World* world) {
    world->clock++;
    const long end = world->step_count + 1;
    while (world->step_count < end) {
        if (world->blowup.halted)
            return;
        make_step(world);
        if (is_over(world))
            return;
        // a bad state is found at its step
        blowup_check(world);
        rest_check(world);
    }
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
        if (world->def.sleep_threshold > 0)
            hash = hash_bytes(hash, &body->still, sizeof body->still);
    }
    for (int s = 0; s < world->contacts.sphere_count; s++) {
        const Sphere* sphere = &world->contacts.sphere[s];
        hash = hash_bytes(hash, &sphere->x, 3 * sizeof(real));
        hash = hash_bytes(hash, &sphere->v, 3 * sizeof(real));
        hash = hash_bytes(hash, &sphere->spin, 3 * sizeof(real));
    }
    for (int k = 0; k < world->thing_count; k++)
        if (world->thing[k].path_count > 0)
            hash = hash_bytes(hash, &world->thing[k].body.x[0], 3 * sizeof(real));
    return joints_hash(&world->system.joints, hash);
}

void world_close(World* world) {
    contacts_close(&world->contacts);
    system_close(&world->system);
    for (int b = 0; b < world->balloon_count; b++)
        balloon_close(&world->balloon[b]);
    free(world->balloon);
    things_close(world);
    knots_close(world);
    scene_free(&world->def);
    *world = (World){0};
}
