/// Things: triangle meshes of infinite mass that skins and balls touch, at rest or on a path.
///
/// A thing is one more skin behind those of the balloons, with all of its particles held. The rows of
/// contact pairs, the solver and the proof that a drift crosses nothing treat it as any skin, except
/// that it has no thickness and wakes nothing while it is at rest. It is a surface with two sides,
/// open or closed: what begins inside a closed one stays inside.
///
/// In a drift of length h each particle, which began at s, has the velocity
///
///     v = V s + (D s - x) min(1 / h, 10 / s),   V = (P(t + h) - P(t)) / h + (P(t) - D) min(1 / h, 10 / s)
///
/// P is the pose on the path (contact/things/path.h), t the thing's own time, D its present pose: a
/// drift that contacts cut leaves D beside P, and rounding x beside D s. A drift is a straight way for
/// each particle and so short that it turns the thing by little.
/// A thing that would press a skin to nothing is held up: it stands still for 0.05 s, then tries again.
/// Its time stands still as long, which slows its path.
#ifndef BALLOON_CONTACT_THINGS_THING_H
#define BALLOON_CONTACT_THINGS_THING_H

#include "body/body.h"
#include "contact/things/path.h"

typedef struct Thing {
    Mesh mesh;
    Body body;     ///< all particles held; asleep: it stands still in the coming drift
    real friction; ///< Coulomb's coefficient of skins on it
    int path_count;
    PathPoint* path; ///< [path_count] in rising order of times
    double4 origin;  ///< about which the path rotates it, at the start [m]
    double radius;   ///< of its farthest point from there [m]
    double spin_max; ///< bound on its angular velocity [rad/s]
    real4* start;    ///< [count] positions without a displacement [m]
    int (*across)
        [3]; ///< [triangle_count] for the side from corner k to the next the opposite point of
             ///< the triangle on its other side; NONE: a rim
    // state
    double time;        ///< along the path [s]
    Pose pose;          ///< D
    Pose velocity;      ///< V [1/s]
    double return_rate; ///< of its particles to D in this drift [1/s]
    double still;       ///< how much longer it stands still since it was held up [s]
    double delay;       ///< sum of the drifts in which it was held up [s]
    bool said;          ///< that it was held up
    // the last good state
    real4* good_x; ///< [count]
    double good_time, good_still, good_delay;
    Pose good_pose;
} Thing;

/// Make a thing at the first positions of its path from a mesh, which the thing then owns, with its
/// points where they are to be at path[0]. origin: about which it turns. path: [path_count], copied.
void thing_make(Thing* thing, const Mesh* mesh, real friction, double4 origin,
                const PathPoint* path, int path_count);

/// Back to the start of its path.
void thing_reset(Thing* thing);

/// The longest drift, at most h, that turns it by little [s].
double thing_safe_step(const Thing* thing, double h);

/// Set the velocity for a drift of length h.
void thing_begin_drift(Thing* thing, double h);

/// Present velocity of a particle that moves with the thing, began at `start` and is at x now [m/s].
real4 thing_particle_velocity(const Thing* thing, double4 start, real4 x);

/// Velocity of the thing's point that is at x now [m/s].
double4 thing_velocity(const Thing* thing, double4 x);

/// Where it would be after h at the present velocity: a point that began at `start` [m].
double4 thing_point(const Thing* thing, double4 start, double h);

/// Let it stand still from this drift on, if it moves.
void thing_hold_up(Thing* thing);

void thing_drift(Thing* thing, double h);

/// Remember the state, and put it back.
void thing_keep(Thing* thing);
void thing_put_back(Thing* thing);

/// Whether the point of a triangle with these weights, the nearest one to x of that triangle, is also
/// the nearest one of those beside it. On a flat face a point over one triangle has a nearest point
/// on the rim of the next one, too: contacts there would stop what slides over it.
bool thing_is_nearest(const Thing* thing, int triangle, const double weight[3], double4 x);

void thing_close(Thing* thing);

#endif
