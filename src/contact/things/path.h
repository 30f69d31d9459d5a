/// Paths of things and knots.
///
/// A path goes in straight lines through points at given times, and rests before the first and after
/// the last. Each point has a rotation, too: angles about the axes x, then y, then z, which go
/// evenly from point to point, so that 720 degrees are two turns. A pose moves a point s of the
/// start, with o the origin of the path and R the product of the rotations Rz Ry Rx, to
///
///     x = s + d + T (s - o),   d = p(t) - p(0),   T = R(t) R(0)^T - 1
///
/// It is linear in (d, T): a weighted sum of poses moves a point to the same sum of its places.
#ifndef BALLOON_CONTACT_THINGS_PATH_H
#define BALLOON_CONTACT_THINGS_PATH_H

#include "base/vec.h"

typedef struct PathPoint {
    double at;        ///< [s]
    double4 position; ///< [m]
    double4 rotation; ///< angles about x, y, z [rad]
} PathPoint;

/// A pose, or a rate of change of one.
typedef struct Pose {
    double4 shift;   ///< d [m]
    double4 turn[3]; ///< columns of T [1]
} Pose;

/// The pose at time t; nothing moves without a path.
Pose path_pose(const PathPoint* path, int count, double t);

/// Rotate a vector by angles about x, then y, then z [rad].
double4 path_rotate(double4 angle, double4 a);

/// Bound on the angular velocity at any time [rad/s].
double path_spin_max(const PathPoint* path, int count);

/// Bound on the speed of points up to `radius` from the origin [m/s].
double path_fastest(const PathPoint* path, int count, double radius);

/// a p + b q
Pose pose_sum(double a, const Pose* p, double b, const Pose* q);

/// Of s, relative to the origin o.
double4 pose_displacement(const Pose* pose, double4 origin, double4 start);

/// The point s that the pose moves to x.
double4 pose_start(const Pose* pose, double4 origin, double4 x);

/// Bound on the displacement of a point up to `radius` from the origin [m].
double pose_reach(const Pose* pose, double radius);

#endif
