/// One balloon of the world: its mesh, its state, and the user's changes.
#ifndef BALLOON_WORLD_BALLOON_H
#define BALLOON_WORLD_BALLOON_H

#include "body/body.h"
#include "constraint/strain_limit.h"
#include "constraint/volume_constraint.h"
#include "solve/method.h"
#include "scene/scene.h"

typedef struct Balloon {
    const BalloonDef* def;
    Mesh mesh;
    Body body;
    StrainLimit strain_limit;
    VolumeConstraint volume_constraint;
    const Method* method;
    void* workspace;      ///< the method's, for this body
    SolveStats stats;     ///< of the last kick
    float color[3];       ///< sRGB 0…1
    double scene_amount;  ///< amount of gas that the scene sets
    double added_amount;  ///< amount that keys, pipes and leaks have added
    double amount_before; ///< amount at the start of this step
    double amount_after;  ///< amount at its end
    double rate;          ///< change of the amount while a key is held [1/s]
    double min_amount;    ///< lower limit of the keys
    double max_amount;    ///< upper limit of the keys
    double vent;          ///< conductance of the valve [1/(s Pa)]
    int strings;          ///< number of strings, tied or not
    real4* good_x;        ///< [count] last good positions
    real4* good_v;        ///< [count] last good velocities
    real* good_thickness; ///< [elements] last good thicknesses
    double sleep_amount;  ///< amount when it fell asleep
    real4* v_start;       ///< [count] velocities before the kick, which an unsolved step restores
} Balloon;

/// Load the model of balloon `number` and make all parts that its def lists.
bool balloon_open(Balloon* balloon, const WorldDef* def, const Method* method, int number,
                  Fault* fault);

/// The particle that `at` names, as StringDef.at; `to`: of `nearest`. NULL: nearest, or without `to`
/// the lowest.
int balloon_particle_at(const Body* body, const char* at, const double to[3]);

/// Center of mass [m].
void balloon_center(const Body* body, double center[3]);

/// Restore the state that balloon_open made: body, strain limits and amount.
void balloon_reset(Balloon* balloon, const WorldDef* def);

/// Gauge pressure on the skin now [Pa].
double balloon_pressure(const Balloon* balloon);

/// Set the inflation's amount at time t: the scene's amount and filling, and the added amount.
void balloon_fill(Balloon* balloon, double t);

/// Inflate for `seconds` at the balloon's rate, up to its limits. Below 0: deflate, a gas through
/// its valve.
void balloon_blow(Balloon* balloon, double seconds);

/// Remove the gas that leaks through the skin in that time.
void balloon_leak(Balloon* balloon, double seconds);

/// Tie all strings, or untie them. A string that is too short for where the balloon is now is tied
/// longer. A balloon without strings in its scene gets one, from its lowest particle straight down
/// to the floor.
void balloon_tie(Balloon* balloon, const WorldDef* def, bool tied);

void balloon_close(Balloon* balloon);

#endif
