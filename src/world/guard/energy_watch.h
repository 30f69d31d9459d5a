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
/// The energy of gas that hands, valves and pipes move is not in it; contacts, drag and
/// friction only take energy. A step whose state is bad
/// (blowup.h), or with
///
///     gain > GAIN turnover,   GAIN = 1/10
///
/// is taken back and made again in half as long substeps, down to 1/64 of what the bound asks for;
/// then the world halts.
///
/// To measure the gain takes two passes over all forces, so most steps are only screened: K can
/// exceed the energy stored at the last measurement only by work from outside or by a gain. A
/// measurement is made where K does exceed it by the same share, and every MEASURE_INTERVAL
/// substeps.
///
/// The watch is on for explicit methods, in the guard's mode `split`, where a step is divided or a
/// force stiffens without limit (force.h), each force is the gradient of an energy and each contact
/// takes energy: not with pressure on an open skin, corrected springs, `volume: global`, a material
/// of variable thickness, or the paper's contact. An undivided step of springs is below a bound that
/// holds, and saving its state would cost 20 % of it.
#ifndef BALLOON_WORLD_GUARD_ENERGY_WATCH_H
#define BALLOON_WORLD_GUARD_ENERGY_WATCH_H

#include <stdbool.h>

typedef struct World World;

typedef struct EnergyWatch {
    bool on;                ///< for this step
    double kinetic_max;     ///< measure above it [J]
    int since_measure;      ///< substeps since the last measurement
    double separation_work; ///< Contacts.separation_work before the step [J]
} EnergyWatch;

/// Before the substeps of a step: save the state.
void energy_watch_start(World* world);

/// After them: whether the step was taken back, and is to be made again.
bool energy_watch_takes_back(World* world);

#endif
