/// Joints: strings that join a particle of a body to a particle of another body, or to a knot.
///
///     d = x_1 - x_0,   T = stiffness max(0, |d| - free length),   E = T^2 / (2 stiffness)
///     force on end 0   T d / |d|, on end 1 the opposite                                     [N]
///
/// A knot is a point that several strings share. A free knot has a mass and no contacts. It is not
/// massless: a massless knot has no position while its strings are slack, and needs a solve of its
/// own in every force evaluation. With a mass, both momenta are kept to rounding. A held knot has
/// infinite mass and rests, or follows a path (contact/things/path.h) or a thing, of which it is a
/// point: so are the ends of strings to things.
///
/// An explicit method adds the forces in its kick; an implicit one has them in its equation
/// (solve/joints/joint_terms.h). The tangent of a joint satisfies
///
///     K = (k, -k; -k, k) <= 2 stiffness (1, 0; 0, 1)
///
/// so that 2 stiffness / m at each end bounds the squared frequency that it adds.
#ifndef BALLOON_SOLVE_JOINTS_JOINTS_H
#define BALLOON_SOLVE_JOINTS_JOINTS_H

#include <stdint.h>

#include "body/body.h"
#include "contact/sphere.h"
#include "contact/things/thing.h"

/// Particle `number` of a body, or with body NONE the knot of this number.
typedef struct JointEnd {
    int body;
    int number;
} JointEnd;

typedef struct Joint {
    JointEnd end[2];    ///< end 0 is a particle
    real stiffness;     ///< [N/m]
    real free_length;   ///< [m]
    real first_stretch; ///< when it was first tied [m]; tied again, it is stretched no more
    bool tied;          ///< false: no force
} Joint;

typedef struct Knot {
    Sphere point;          ///< position, velocity and mass; its radius and spin have no effect
    bool held;             ///< infinite mass
    double4 start;         ///< position at the first point of the path, or of the thing's [m]
    const Thing* thing;    ///< that it is a point of; NULL: none
    const PathPoint* path; ///< [path_count] owned by the caller
    int path_count;
    double w2;      ///< bound on the squared frequency that the joints add [1/s^2]; 0: held
    int body;       ///< a body that is joined to it, or NONE
    real4 v_before; ///< velocity before joints_begin [m/s]
    Sphere good;    ///< last good state
} Knot;

typedef struct Joints {
    Body* const* body; ///< [body_count] the system's
    int body_count;
    Joint* joint; ///< [count]
    int count, capacity;
    Knot* knot; ///< [knot_count]
    int knot_count, knot_capacity;
    int* joined; ///< [body_count] the first of the bodies that joints and free knots connect to it
    double gravity;   ///< downward, on free knots [m/s^2]
    double time;      ///< of held knots' paths [s]
    double good_time; ///< of the last good state [s]
} Joints;

void joints_open(Joints* joints, Body* const* body, int body_count, double gravity);
void joints_close(Joints* joints);

/// A knot at `position`: with a mass [kg], or with 0 held. path: [path_count].
void joints_add_knot(Joints* joints, const double position[3], double mass, const PathPoint* path,
                     int path_count);

/// A held knot at a point of a thing. Returns its number.
int joints_add_thing_point(Joints* joints, const Thing* thing, const double point[3]);

/// A string of `slack` times the present distance of its ends.
void joints_add(Joints* joints, JointEnd from, JointEnd to, double stiffness, double slack);

/// Position of an end after h, for a knot with its present velocity; a particle's is the present one.
real4 joint_position(const Joints* joints, JointEnd end, double h);

/// Force on end 0 [N] with the ends where joint_position has them after h; 0 while slack.
real4 joint_force(const Joints* joints, const Joint* joint, double h);

/// Tension at the present positions [N].
double joint_tension(const Joints* joints, const Joint* joint);

/// E of a joint after a drift of length h of its knot [J].
double joint_energy(const Joints* joints, const Joint* joint, double h);

/// Lengthen a joint that is tied again to where its ends are now, as string_tied_length says.
void joint_reach(const Joints* joints, Joint* joint);

/// Energy of all joints at the present positions [J].
double joints_energy(const Joints* joints);

/// Begin a kick of length h: weight of free knots, velocities of held ones.
void joints_begin(Joints* joints, double h);

/// Undo joints_begin and what the kick has changed.
void joints_undo(Joints* joints);

/// v' = v + h f / m of both ends, for an explicit method.
void joints_push(Joints* joints, double h);

/// x' = x + h v' of the knots.
void joints_drift(Joints* joints, double h);

/// The hash continued with the positions and velocities of the knots.
uint64_t joints_hash(const Joints* joints, uint64_t hash);

/// Whether a knot follows a path, its own or a thing's.
bool joints_are_led(const Joints* joints);

/// Add the forces of the joints at the present positions to the f of a body.
void joints_add_forces(const Joints* joints, const Body* body);

/// Exchange the knots' present state and the saved one.
void joints_swap(Joints* joints);

/// Save and restore the knots.
void joints_keep(Joints* joints);
void joints_put_back(Joints* joints);

#endif
