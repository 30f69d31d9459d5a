#include "world/guard/energy_watch.h"

#include "base/vectors.h"
#include "force/inflation.h"
#include "force/material.h"
#include "mesh/measure.h"
#include "world/world.h"

enum {
    MEASURE_INTERVAL = 1024, ///< [substeps]
    SCREEN_INTERVAL = 8,     ///< [substeps] of steps whose state is not saved
    SUBSTEPS_SAVED = 2       ///< the state is saved before each step of so many substeps
};

/// GAIN: energy that a step may gain. [of its turnover]
static const double gain_max = 0.1;

/// Speed of a motion that is none, for a world without energy. [of the balloon's size per second]
static const double speed_floor = 0.01;

/// Kinetic and stored energy, and the sum of the energies of all forces but the pressure. [J]
typedef struct Energies {
    double kinetic, stored, forces;
} Energies;

static bool body_has_energy(const Balloon* balloon) {
    const Membrane* membrane = &balloon->body.membrane;
    const bool encloses = balloon->body.mesh->closed || !force_inflation.present(&balloon->body);
    return encloses && !balloon->strain_limit.on &&
           (membrane->count == 0 ||
            (membrane->rubber.rule == VOLUME_LOCAL && !membrane->rubber.material->reads_thickness));
}

static bool is_watched(const World* world) {
    if (!guard_splits(&world->guard, world->method) ||
        (world->contacts.law == CONTACT_PAPER && world->contacts.sphere_count > 0))
        return false;
    // the work of what follows a path is unknown, but for that of contacts
    if (joints_are_led(&world->system.joints) || pins_are_led(&world->contacts.pins))
        return false;
    for (int b = 0; b < world->balloon_count; b++)
        if (!body_has_energy(&world->balloon[b]))
            return false;
    return true;
}

static double ball_kinetic(const Sphere* ball) {
    return (double)(ball->mass * dot(ball->v, ball->v) +
                    sphere_inertia(ball) * dot(ball->spin, ball->spin)) /
           2;
}

static double kinetic(const World* world) {
    double sum = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        const Body* body = &world->balloon[b].body;
        sum += vectors()->weighted_squares(body->mass, body->v, body->count) / 2;
    }
    for (int s = 0; s < world->contacts.sphere_count; s++)
        sum += ball_kinetic(&world->contacts.sphere[s]);
    for (int k = 0; k < world->system.joints.knot_count; k++)
        sum += ball_kinetic(&world->system.joints.knot[k].point);
    return sum;
}

/// Energy of the gas above that of the air's pressure, to the second order in p.
static double gas_stored(const Body* body) {
    const Inflation* gas = &body->inflation;
    if (gas->law != INFLATE_GAS)
        return 0;
    const double volume = measure_volume(body->mesh, body->x), p = gas_pressure(gas, volume);
    return p * p * volume / (2 * fmax(gas->ambient, fabs(p)));
}

/// Kinetic energy at the time of the positions: of v + (h/2) f/m where v is staggered by h/2, which
/// takes the oscillation of a symplectic method's energy out but for its second order. f is that of
/// the amount of gas at that time.
static double kinetic_at_positions(const World* world, Body* body, double amount) {
    if (!world->method->staggered || body->asleep)
        return vectors()->weighted_squares(body->mass, body->v, body->count) / 2;
    const double now = body->inflation.amount;
    body->inflation.amount = amount;
    force_sum(body);
    body->inflation.amount = now;
    joints_add_forces(&world->system.joints, body);
    const real half = (real)(world->kicked / 2);
    double sum = 0;
    for (int i = 0; i < body->count; i++) {
        const real4 v = body->v[i] + (half * body->inverse_mass[i]) * body->f[i];
        sum += (double)(body->mass[i] * dot(v, v));
    }
    return sum / 2;
}

/// A balloon with its present gas, or that of the start of the step.
static void add_balloon(const World* world, Balloon* balloon, bool before, Energies* sum) {
    Body* body = &balloon->body;
    for (int k = 0; k < force_count; k++) {
        const Force* force = force_table[k];
        if (!force->energy || force == &force_inflation || !force->present(body))
            continue;
        const double energy = force->energy(body);
        sum->forces += energy;
        sum->stored += force->elastic ? energy : 0;
    }
    const double floor = speed_floor * body->size;
    double mass = 0;
    for (int i = 0; i < body->count; i++)
        mass += (double)body->mass[i];
    sum->kinetic +=
        kinetic_at_positions(world, body, before ? balloon->amount_before : body->inflation.amount);
    sum->stored += gas_stored(body) + mass * floor * floor / 2;
}

static void add_balls(const World* world, const Sphere* ball, int count, Energies* sum) {
    for (int s = 0; s < count; s++) {
        sum->kinetic += ball_kinetic(&ball[s]);
        sum->forces += (double)ball[s].mass * world->contacts.gravity * (double)ball[s].x[1];
    }
}

/// Joints and free knots.
static void add_joints(const World* world, Energies* sum) {
    const Joints* joints = &world->system.joints;
    const double energy = joints_energy(joints);
    sum->forces += energy;
    sum->stored += energy;
    for (int k = 0; k < joints->knot_count; k++)
        if (!joints->knot[k].held)
            add_balls(world, &joints->knot[k].point, 1, sum);
}

/// The saved state instead of the present one, and back.
static void swap_states(World* world) {
    for (int b = 0; b < world->balloon_count; b++) {
        Balloon* balloon = &world->balloon[b];
        real4 *const x = balloon->body.x, *const v = balloon->body.v;
        balloon->body.x = balloon->good_x, balloon->body.v = balloon->good_v;
        balloon->good_x = x, balloon->good_v = v;
    }
    joints_swap(&world->system.joints);
}

static Energies measure(World* world, const Sphere* ball, int balls, bool before) {
    Energies sum = {0};
    for (int b = 0; b < world->balloon_count; b++)
        add_balloon(world, &world->balloon[b], before, &sum);
    add_balls(world, ball, balls, &sum);
    add_joints(world, &sum);
    sum.stored += sum.kinetic;
    return sum;
}

/// Pressure at the mean of two volumes and two amounts, of a gas; else p.
static double pressure_between(const Inflation* inflation, double p, const double volume[2],
                               double amount_before) {
    if (inflation->law != INFLATE_GAS)
        return p;
    Inflation gas = *inflation;
    gas.amount = (gas.amount + amount_before) / 2;
    return gas_pressure(&gas, (volume[0] + volume[1]) / 2);
}

/// Pressure that the gas of this step adds at the mean volume.
static double entered_pressure(const Inflation* inflation, const double volume[2],
                               double amount_before) {
    if (inflation->law != INFLATE_GAS)
        return 0;
    Inflation before = *inflation;
    before.amount = amount_before;
    const double mean = (volume[0] + volume[1]) / 2;
    return gas_pressure(inflation, mean) - gas_pressure(&before, mean);
}

/// Work of the pressure over the step [J], from the saved state to the present one, while the
/// amounts of gas change evenly; *doubt: by how much it may be another, as they do not (energy_watch.h).
static double pressure_work(World* world, double* doubt) {
    double sum = 0;
    *doubt = 0;
    for (int b = 0; b < world->balloon_count; b++) {
        const Balloon* balloon = &world->balloon[b];
        const Body* body = &balloon->body;
        if (!force_inflation.present(body))
            continue;
        const double volume[2] = {measure_volume(body->mesh, balloon->good_x),
                                  measure_volume(body->mesh, body->x)};
        const double after = inflation_pressure(body);
        Body before = *body;
        before.x = balloon->good_x;
        before.inflation.amount = balloon->amount_before;
        const double first = inflation_pressure(&before), mean = (first + after) / 2;
        const double middle =
            pressure_between(&body->inflation, mean, volume, balloon->amount_before);
        sum += (first + 4 * middle + after) / 6 * (volume[1] - volume[0]);
        *doubt += fabs(entered_pressure(&body->inflation, volume, balloon->amount_before) *
                       (volume[1] - volume[0])) /
                  2;
    }
    return sum;
}

/// What a step did to the energy. [J]
typedef struct Balance {
    double gain;     ///< NaN where it was not measured
    double turnover; ///< stored before, and converted in the step
} Balance;

static Balance measure_balance(World* world) {
    Contacts* contacts = &world->contacts;
    swap_states(world);
    const Energies before = measure(world, contacts->good, contacts->good_count, true);
    swap_states(world);
    const Energies after = measure(world, contacts->sphere, contacts->sphere_count, false);
    world->watch.kinetic_max = (1 + gain_max) * after.stored;
    world->watch.since_measure = 0;
    const double forces = after.forces - before.forces;
    const double separation = contacts->separation_work - world->watch.separation_work;
    double doubt;
    const double work = pressure_work(world, &doubt) + separation;
    return (Balance){.gain = after.kinetic - before.kinetic + forces - work - doubt,
                     .turnover = before.stored + fabs(forces) + fabs(work)};
}

void energy_watch_start(World* world) {
    EnergyWatch* watch = &world->watch;
    world->guard.made_again = false;
    watch->on = is_watched(world);
    watch->saved = watch->on && (watch->due || world->guard.substeps >= SUBSTEPS_SAVED);
    watch->separation_work = world->contacts.separation_work;
    if (watch->saved)
        blowup_save_state(world);
}

/// Whether the energy is to be measured: K is above its limit, or it was not for long.
static bool is_due(const World* world) {
    // written so that a NaN is measured
    return !(kinetic(world) <= world->watch.kinetic_max) ||
           world->watch.since_measure >= MEASURE_INTERVAL;
}

/// After a step whose state was not saved: measure the next one, if need be.
static void screen(World* world) {
    EnergyWatch* watch = &world->watch;
    if (watch->since_screen < SCREEN_INTERVAL)
        return;
    watch->since_screen = 0;
    watch->due = is_due(world);
}

bool energy_watch_takes_back(World* world) {
    EnergyWatch* watch = &world->watch;
    if (!watch->on || world->blowup.halted)
        return false;
    watch->since_measure += world->guard.substeps;
    watch->since_screen += world->guard.substeps;
    if (!watch->saved)
        screen(world);
    if (!watch->saved || !(watch->due || is_due(world)))
        return false;
    watch->due = false;
    Balance balance = {.gain = (double)NAN};
    if (!blowup_is_bad(world)) {
        balance = measure_balance(world);
        if (balance.gain <= gain_max * balance.turnover)
            return false;
    }
    if (!guard_refine(&world->guard)) {
        if (isfinite(balance.gain)) // a bad state is named by its own sentence
            blowup_gained(world, balance.gain, balance.turnover);
        return false;
    }
    world->guard.taken_back++;
    watch->kinetic_max = 0;
    blowup_take_back(world);
    return true;
}

/// Whether each step since the saved state would be the same again: nothing came from outside.
static bool is_repeatable(const World* world) {
    if (world->watch.touched || world->held || world->def.pipes_count > 0)
        return false;
    for (int b = 0; b < world->balloon_count; b++) {
        const InflationDef* inflation = world->balloon[b].def->inflation;
        if (inflation && inflation->leak > 0)
            return false;
    }
    return true;
}

bool energy_watch_goes_back(World* world) {
    if (!world->watch.on || world->watch.saved || !is_repeatable(world) ||
        !guard_refine(&world->guard))
        return false;
    world->guard.taken_back++;
    world->watch.kinetic_max = 0;
    world->watch.due = true;
    blowup_take_back(world);
    world->step_count = world->good_step;
    return true;
}
