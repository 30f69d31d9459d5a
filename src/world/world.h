/// The world: balloons, the step, and the user's events.
///
/// `world_step` is the whole simulation in the order of the equations. It does not depend on wall
/// time, windows or pictures: the same def and the same events give the same bits.
#ifndef BALLOON_WORLD_WORLD_H
#define BALLOON_WORLD_WORLD_H

#include <stdint.h>

#include "contact/contacts.h"
#include "solve/method.h"
#include "world/balloon.h"
#include "world/guard/blowup.h"
#include "world/guard/energy_watch.h"
#include "world/record.h"
#include "scene/scene.h"

enum { ALL_BALLOONS = -1 }; ///< no balloon is selected: keys act on all

struct World {
    WorldDef def;
    const Method* method;
    Balloon* balloon; ///< [balloon_count]
    int balloon_count;
    Thing* thing; ///< [thing_count] (world/things/things.h)
    int thing_count;
    PathPoint** knot_path; ///< [knots of the def] points of the paths of held knots
    System system;     ///< the balloons' bodies, as the method steps them; their strings to knots
    Contacts contacts; ///< balls, floor, walls, things
    double step;       ///< h [s]
    long step_count;   ///< steps since the start or the last reset
    long clock;        ///< calls of world_step since world_open, also across resets
    long good_step;    ///< the step of the last good state
    int selected;      ///< balloon that keys act on, or ALL_BALLOONS
    unsigned held;     ///< commands whose key is down, bit k for row k of command_table
    StepGuard guard;
    EnergyWatch watch;
    double kicked;    ///< length of the last kick [s]
    double solvable;  ///< longest substep that the method could last solve [of the step]
    double corrected; ///< longest substep where velocities are corrected after the solve [s]
    Blowup blowup;
    char notice[256]; ///< a message that the program shows once; empty: none
};

/// Make the world of a def, which the world then owns (it is freed with the world, and also when
/// this fails). Bad models and refused pairs are faults.
bool world_open(World* world, WorldDef* def, Fault* fault);

/// One fixed step: kick, strain limits, contacts, drift, check, rest. Once halted, only the clock
/// advances.
void world_step(World* world);

/// Restore the state after world_open, except the clock.
void world_reset(World* world);

/// Apply an event of the input log. Unknown keys are faults.
bool world_event(World* world, const Event* event, Fault* fault);

/// Whether an event of a log that was read can be applied to this world.
bool world_event_check(const World* world, const Event* event, Fault* fault);

/// Simulated time [s].
static inline double world_time(const World* world) {
    return (double)world->step_count * world->step;
}

/// Hash of the position and velocity of every particle (balloons in order, particles in loaded
/// order), ball and thing on a path; where balloons may sleep, also of how long they have been still.
uint64_t world_hash(const World* world);

void world_close(World* world);

#endif
