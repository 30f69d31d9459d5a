#include "contact/things/path.h"

/// Where t is: the last point that is not after it, and the part of the way to the next. The first
/// point before the path begins, the last one after it has ended.
static const PathPoint* find(const PathPoint* path, int count, double t, double* part) {
    *part = 0;
    if (t <= path->at)
        return path;
    for (const PathPoint* to = path + 1; to < path + count; to++)
        if (t < to->at) {
            *part = (t - to[-1].at) / (to->at - to[-1].at);
            return to - 1;
        }
    return path + count - 1;
}

double4 path_rotate(double4 angle, double4 a) {
    for (int k = 0; k < 3; k++) {
        const double c = cos(angle[k]), s = sin(angle[k]);
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        const double4 before = a;
        a[u] = c * before[u] - s * before[v];
        a[v] = s * before[u] + c * before[v];
    }
    return a;
}

/// Rotate back: the inverse of path_rotate.
static double4 rotate_back(double4 angle, double4 a) {
    for (int k = 2; k >= 0; k--) {
        double4 one = {0};
        one[k] = -angle[k];
        a = path_rotate(one, a);
    }
    return a;
}

static bool is_rotated(const PathPoint* path, int count) {
    for (int k = 0; k < count; k++)
        if (dlength(path[k].rotation) > 0)
            return true;
    return false;
}

Pose path_pose(const PathPoint* path, int count, double t) {
    Pose pose = {0};
    if (count == 0)
        return pose;
    double part;
    const PathPoint* at = find(path, count, t, &part);
    if (at > path || part > 0) { // exactly nothing before the path begins
        pose.shift = at->position - path->position;
        if (part > 0)
            pose.shift += part * (at[1].position - at->position);
    }
    if (!is_rotated(path, count))
        return pose;
    const double4 angle =
        part > 0 ? at->rotation + part * (at[1].rotation - at->rotation) : at->rotation;
    for (int k = 0; k < 3 && dlength(angle - path->rotation) > 0; k++) {
        double4 axis = {0};
        axis[k] = 1;
        pose.turn[k] = path_rotate(angle, rotate_back(path->rotation, axis)) - axis;
    }
    return pose;
}

double path_spin_max(const PathPoint* path, int count) {
    double fastest = 0;
    for (int k = 1; k < count; k++) {
        const double4 angle = path[k].rotation - path[k - 1].rotation;
        const double sum = fabs(angle[0]) + fabs(angle[1]) + fabs(angle[2]);
        fastest = fmax(fastest, sum / (path[k].at - path[k - 1].at));
    }
    return fastest;
}

double path_fastest(const PathPoint* path, int count, double radius) {
    double fastest = 0;
    for (int k = 1; k < count; k++) {
        const double time = path[k].at - path[k - 1].at,
                     straight = dlength(path[k].position - path[k - 1].position) / time;
        fastest = fmax(fastest, straight + radius * path_spin_max(path + k - 1, 2));
    }
    return fastest;
}

Pose pose_sum(double a, const Pose* p, double b, const Pose* q) {
    Pose sum = {.shift = a * p->shift + b * q->shift};
    for (int k = 0; k < 3; k++)
        sum.turn[k] = a * p->turn[k] + b * q->turn[k];
    return sum;
}

double4 pose_displacement(const Pose* pose, double4 origin, double4 start) {
    const double4 r = start - origin;
    return pose->shift + (r[0] * pose->turn[0] + r[1] * pose->turn[1] + r[2] * pose->turn[2]);
}

double4 pose_start(const Pose* pose, double4 origin, double4 x) {
    double4 column[3];
    for (int k = 0; k < 3; k++) {
        column[k] = pose->turn[k];
        column[k][k] += 1;
    }
    const double4 r = x - origin - pose->shift; // Cramer's rule
    const double4 normal[3] = {dcross(column[1], column[2]), dcross(column[2], column[0]),
                               dcross(column[0], column[1])};
    const double determinant = ddot(column[0], normal[0]);
    double4 start = origin;
    for (int k = 0; k < 3; k++)
        start[k] += ddot(normal[k], r) / determinant;
    return start;
}

double pose_reach(const Pose* pose, double radius) {
    return dlength(pose->shift) +
           radius * (dlength(pose->turn[0]) + dlength(pose->turn[1]) + dlength(pose->turn[2]));
}
