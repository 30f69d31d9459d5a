/// Random encounters: 2 to 6 balloons at random places that fly at each other at up to 50 m/s, by any
/// method, each with the skins that it takes. Half of them lie between two plates on paths, which
/// press them to a tenth of their size or less and open again.
///
/// The number of an encounter draws everything: model and size, place, velocity, skin, gas, damping,
/// friction, step and method.
#ifndef BALLOON_LAB_BENCH_ENCOUNTER_H
#define BALLOON_LAB_BENCH_ENCOUNTER_H

#include "world/world.h"

typedef struct Encounter {
    World world;
    bool squeezed;
    double seconds;      ///< how long it lasts
    double squeezed_at;  ///< when the plates are nearest [s]
    char scene[5][64];   ///< what is set besides the balloons
    char balloons[3072]; ///< and they
} Encounter;

enum { ENCOUNTER_LOOKS = 40 }; ///< states a second in which crossings are counted

/// Open number `seed`; `simple`: of few particles and not by forward.
bool encounter_open(Encounter* encounter, uint64_t seed, bool simple, Fault* fault);

/// Step to the next state that is looked at. False when it is over.
bool encounter_go_on(Encounter* encounter);

void encounter_close(Encounter* encounter);

#endif
