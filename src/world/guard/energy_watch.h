/// The energy watch, the guard's second line: a step may not gain energy.
///
///     gain   = K' - K + sum of (E' - E) over forces with an energy - work                    [J]
///     work   = integral of p dV over the step, Simpson's rule, of gas that enters evenly,
///              and what contacts give to undo rigid overlaps                                     [J]
///     doubt  = half of what that integral changes by if all gas enters at the step's start, or at
///              its end: a skin at rest gives way late, V - V0 ~ t^3, and the gain is less by it  [J]
///     stored = K + elastic energy + p^2 V / (2 ambient), the gas's energy above the air's    [J]
///     turnover = stored before + |sum of (E' - E)| + |work|                                  [J]
///
/// over all balloons and balls, K kinetic, at the time of the positions (method.h, `staggered`).
/// The energy of gas that hands, valves and pipes move is not in it; contacts, drag and friction only take
/// energy. A step whose state is bad (blowup.h), or with
///
///     gain > GAIN turnover,   GAIN = 1/10
///
/// is taken back and made again in half as long substeps, down to 1/64 of what the bound asks for;
/// then the world halts.
///
/// To measure the gain takes two passes over all forces, and a copy of the state before the step. Most
/// steps are only screened: K can exceed the energy stored at the last measurement only by work from
/// outside or by a gain. A measurement is made where K does exceed it by the same share, and every
/// MEASURE_INTERVAL substeps.
///
/// A copy costs as much as 16 % of a substep, a screening 3 %. So the state is saved before each step of
/// SUBSTEPS_SAVED substeps or more; a shorter one is screened every SCREEN_INTERVAL substeps, and where
/// that asks for a measurement, the next step is saved and measured: an instability gains in that one,
/// too. Where the state goes bad before, all steps since the last good state, at most GUARD_INTERVAL, are
/// made again, unless an event, a held key, a pipe or a leak came between. `bench speed` shows what the
/// watch costs: at most 3 % of an undivided step; 16 % shared by the substeps of a divided one, where a
/// gain that is not taken back at once was measured (a stiff joint, a hit of two skins).
///
/// The watch is on for explicit methods, in the guard's mode `split`, where each force is the gradient of
/// an energy and each contact takes energy: not with pressure on an open skin, corrected springs,
/// `volume: global`, a material of variable thickness, the paper's contact,
/// a knot on a path, or pins to a thing on one.
#ifndef BALLOON_WORLD_GUARD_ENERGY_WATCH_H
#define BALLOON_WORLD_GUARD_ENERGY_WATCH_H

#include <stdbool.h>

typedef struct World World;

typedef struct EnergyWatch {
    bool on;                ///< for this step
    bool saved;             ///< the state before this step is
    bool due;               ///< measure the next step
    bool touched;           ///< an event came after the last good state
    double kinetic_max;     ///< measure above it [J]
    int since_measure;      ///< substeps since the last measurement
    int since_screen;       ///< substeps since the last screening
    double separation_work; ///< Contacts.separation_work before the step [J]
} EnergyWatch;

/// Before the substeps of a step: save the state, if it may be taken back.
void energy_watch_start(World* world);

/// In a bad state after a step: whether the last good one, of `step_count`, is back, to step on from.
bool energy_watch_goes_back(World* world);

/// After the substeps: whether the step was taken back, and is to be made again.
bool energy_watch_takes_back(World* world);

#endif
