/// Things: triangle meshes of infinite mass that skins and balls touch, at rest or on a path.
///
/// A thing is one more skin behind those of the balloons, with all of its particles held. The rows of
/// contact pairs, the solver and the proof that a drift crosses nothing treat it as any skin, except
/// that it has no thickness and wakes nothing while it is at rest. It is a surface with two sides,
/// open or closed: what begins inside a closed one stays inside.
///
/// A path goes in straight lines through points at given times, and rests before the first and after
/// the last. In a drift of length h all particles have the velocity
///
///     v = (p(t + h) - p(t)) / h + (p(t) - d) min(1 / h, 10 / s)
///
/// p is the path's displacement, t the thing's own time, d its present displacement: a drift that
/// contacts cut leaves d beside p. Each particle comes back in the same way from what rounding adds.
/// A thing that would press a skin to nothing is held up: it stands still for 0.05 s, then tries again.
/// Its time stands still as long, which slows its path.
#ifndef BALLOON_CONTACT_THINGS_THING_H
#define BALLOON_CONTACT_THINGS_THING_H

#include "body/body.h"

typedef struct PathPoint {
    double at;        ///< [s]
    double4 position; ///< [m]
} PathPoint;

typedef struct Thing {
    Mesh mesh;
    Body body;     ///< all particles held; asleep: it stands still in the coming drift
    real friction; ///< Coulomb's coefficient of skins on it
    int path_count;
    PathPoint* path; ///< [path_count] in rising order of times
    real4* start;    ///< [count] positions without a displacement [m]
    int (*across)
        [3]; ///< [triangle_count] for the side from corner k to the next the opposite point of
             ///< the triangle on its other side; NONE: a rim
    // state
    double time;          ///< along the path [s]
    double4 displacement; ///< [m]
    double4 velocity;     ///< of all particles, but for the return of each from rounding [m/s]
    double still;         ///< how much longer it stands still since it was held up [s]
    double delay;         ///< sum of the drifts in which it was held up [s]
    bool said;            ///< that it was held up
    // the last good state
    real4* good_x; ///< [count]
    double good_time, good_still, good_delay;
    double4 good_displacement;
} Thing;

/// Displacement at time t from the first point of a path of `count` points; 0 without a path [m].
double4 path_displacement(const PathPoint* path, int count, double t);

/// Make a thing at the first positions of its path from a mesh, which the thing then owns, with its
/// points where they are to be at path[0]. path: [path_count], copied.
void thing_make(Thing* thing, const Mesh* mesh, real friction, const PathPoint* path,
                int path_count);

/// Back to the start of its path.
void thing_reset(Thing* thing);

/// Set the velocity for a drift of length h.
void thing_begin_drift(Thing* thing, double h);

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
