/// The world: balloons, the step, and what a user may do to it.
///
/// `world_step` is the whole simulation in the order of the equations. Nothing here knows of wall
/// time, windows or pictures; the same def and the same events give the same bits.
#ifndef BALLOON_WORLD_WORLD_H
#define BALLOON_WORLD_WORLD_H

#include <stdint.h>

#include "contact/contacts.h"
#include "solve/method.h"
#include "world/balloon.h"
#include "world/blowup.h"
#include "world/record.h"
#include "scene/scene.h"

enum { ALL_BALLOONS = -1 }; ///< no balloon is selected: keys act on all

struct World {
    WorldDef def;
    const Method* method;
    Balloon* balloon; ///< [balloon_count]
    int balloon_count;
    System system;     ///< the balloons' bodies, as the method steps them
    Contacts contacts; ///< balls, floor, walls
    double step;       ///< h [s]
    long step_count;   ///< steps since the start or the last reset
    long clock;        ///< calls of world_step since world_open, which a reset does not turn back
    long good_step;    ///< the step of the last good state
    int selected;      ///< balloon that keys act on, or ALL_BALLOONS
    unsigned held;     ///< commands whose key is down, bit k for row k of command_table
    StepGuard guard;
    double drift;    ///< length of the last drift, shorter where balls are near [s]
    double solvable; ///< part of a step that the method last could solve [1]
    Blowup blowup;
    char notice[256]; ///< to be shown once; empty: nothing
};

/// Make the world of a def, which the world then owns (it is freed with the world, and also when
/// this fails). Bad models and refused pairs are faults.
bool world_open(World* world, WorldDef* def, Fault* fault);

/// One fixed step: kick, correction, contacts, drift, guard, rest. Once halted, only the clock goes
/// on.
void world_step(World* world);

/// Everything as world_open left it.
void world_reset(World* world);

/// Apply an event of the input log. Unknown keys are faults.
bool world_event(World* world, const Event* event, Fault* fault);

/// Simulated time [s].
static inline double world_time(const World* world) {
    return (double)world->step_count * world->step;
}

/// Hash of every particle's position and velocity, balloons in order, particles in loaded order,
/// and of every ball's; where balloons may sleep, for how long they have been still.
uint64_t world_hash(const World* world);

void world_close(World* world);

#endif
