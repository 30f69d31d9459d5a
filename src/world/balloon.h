/// One balloon of the world: its mesh, its state, and what the user's hand changed.
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
    double given;         ///< amount that the scene gives
    double hand;          ///< amount that the keys have added
    double rate;          ///< amount per second while a key is held
    double least;         ///< the keys stop here
    double most;          ///< and here
    double vent;          ///< amount that the valve lets out per second and pascal [1/(s Pa)]
    int strings;          ///< how many strings there are, tied or not
    real4* good_x;        ///< [count] last good positions
    real4* good_v;        ///< [count] last good velocities
    real* good_thickness; ///< [elements] last good thicknesses
    double slept_with;    ///< amount when it fell asleep
    real4* v_start;       ///< [count] before the kick, where it may have to be taken back
} Balloon;

/// Load the model of balloon `number` and make everything that its def lists.
bool balloon_open(Balloon* balloon, const WorldDef* def, const Method* method, int number,
                  Fault* fault);

/// The state as balloon_open made it: body, correction and the hand's amount.
void balloon_reset(Balloon* balloon, const WorldDef* def);

/// Gauge pressure on the skin now [Pa].
double balloon_pressure(const Balloon* balloon);

/// The inflation's amount at time t: what the scene gives and fills, and what the keys added.
void balloon_fill(Balloon* balloon, double t);

/// Blow by `seconds` at the balloon's rate (less than 0: let out, a gas through its valve), up to
/// its limits.
void balloon_blow(Balloon* balloon, double seconds);

/// What a gas loses through its skin in that time.
void balloon_leak(Balloon* balloon, double seconds);

/// Tie all strings, or untie them. A balloon whose scene gives none gets one, from its lowest
/// particle straight down to the floor.
void balloon_tie(Balloon* balloon, const WorldDef* def, bool tied);

void balloon_close(Balloon* balloon);

#endif
