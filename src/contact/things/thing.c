#include "contact/things/thing.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/point_corners.h"

static const double return_rate_max = 10; ///< [1/s] to the path
static const double turn_max = 0.25;      ///< [rad] in a drift

static const double still_time = 0.05; ///< [s] of a thing that is held up

/// [1] Cosines this small are rounding.
static const double cosine_min = 1e-9;

static int opposite_point(const int triangle[3], int a, int b) {
    int k = 0;
    while (triangle[k] == a || triangle[k] == b)
        k++;
    return triangle[k];
}

/// The points opposite of all sides, from the triangles around each point.
static void find_across(Thing* thing) {
    const Mesh* mesh = &thing->mesh;
    PointCorners corners = point_corners_open(mesh);
    for (int t = 0; t < mesh->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const int a = mesh->triangle[t][k], b = mesh->triangle[t][(k + 1) % 3];
            thing->across[t][k] = NONE;
            for (int c = corners.from[a]; c < corners.from[a + 1]; c++) {
                const int other = corners.corner[c] / 3;
                if (other != t && triangle_has(mesh->triangle[other], b))
                    thing->across[t][k] = opposite_point(mesh->triangle[other], a, b);
            }
        }
    point_corners_close(&corners);
}

void thing_make(Thing* thing, const Mesh* mesh, real friction, double4 origin,
                const PathPoint* path, int path_count) {
    const int count = mesh->point_count;
    *thing = (Thing){.mesh = *mesh,
                     .friction = friction,
                     .origin = origin,
                     .path_count = path_count,
                     .path = new_array(PathPoint, path_count),
                     .start = new_array(real4, count),
                     .across = new_array(int[3], mesh->triangle_count),
                     .good_x = new_array(real4, count)};
    body_make(&thing->body, &thing->mesh, &(Placement){.scale = 1}, INFINITY);
    memcpy(thing->start, thing->body.x, (size_t)count * sizeof(real4));
    for (int k = 0; k < path_count; k++)
        thing->path[k] = path[k];
    for (int i = 0; i < count; i++)
        thing->radius = fmax(thing->radius, dlength(to_double4(thing->start[i]) - thing->origin));
    thing->spin_max = path_spin_max(path, path_count);
    find_across(thing);
    thing_reset(thing);
}

static void stand_still(Thing* thing) {
    thing->body.asleep = true;
    thing->velocity = (Pose){0};
    memset(thing->body.v, 0, (size_t)thing->body.count * sizeof(real4));
}

void thing_reset(Thing* thing) {
    thing->time = thing->still = thing->delay = 0;
    thing->pose = (Pose){0};
    thing->said = false;
    memcpy(thing->body.x, thing->start, (size_t)thing->body.count * sizeof(real4));
    stand_still(thing);
    thing_keep(thing);
}

void thing_begin_drift(Thing* thing, double h) {
    if (thing->path_count == 0)
        return;
    if (thing->still > 0) {
        stand_still(thing);
        return;
    }
    Body* body = &thing->body;
    const double rate = fmin(1 / h, return_rate_max);
    const Pose now = path_pose(thing->path, thing->path_count, thing->time),
               next = path_pose(thing->path, thing->path_count, thing->time + h),
               lag = pose_sum(1, &now, -1, &thing->pose), along = pose_sum(1, &next, -1, &now);
    // at rest a rounding remains as it is
    if (pose_reach(&along, thing->radius) == 0 &&
        pose_reach(&lag, thing->radius) <= (double)REAL_EPSILON * body->size) {
        stand_still(thing);
        return;
    }
    thing->velocity = (Pose){.shift = along.shift / h + rate * lag.shift};
    for (int k = 0; k < 3; k++)
        thing->velocity.turn[k] = along.turn[k] / h + rate * lag.turn[k];
    thing->return_rate = rate;
    body->asleep = false;
    for (int i = 0; i < body->count; i++)
        body->v[i] = thing_particle_velocity(thing, to_double4(thing->start[i]), body->x[i]);
}

double thing_safe_step(const Thing* thing, double h) {
    return thing->spin_max > 0 ? fmin(h, turn_max / thing->spin_max) : h;
}

real4 thing_particle_velocity(const Thing* thing, double4 start, real4 x) {
    if (thing->body.asleep)
        return (real4){0, 0, 0, 0};
    const double4 to = start + pose_displacement(&thing->pose, thing->origin, start);
    return to_real4(pose_displacement(&thing->velocity, thing->origin, start) +
                    thing->return_rate * (to - to_double4(x)));
}

double4 thing_velocity(const Thing* thing, double4 x) {
    return thing->spin_max > 0 ? pose_displacement(&thing->velocity, thing->origin,
                                                   pose_start(&thing->pose, thing->origin, x))
                               : thing->velocity.shift;
}

double4 thing_point(const Thing* thing, double4 start, double h) {
    const Pose then = pose_sum(1, &thing->pose, h, &thing->velocity);
    return start + pose_displacement(&then, thing->origin, start);
}

void thing_hold_up(Thing* thing) {
    if (thing->body.asleep)
        return;
    thing->still = still_time;
    stand_still(thing);
}

void thing_drift(Thing* thing, double h) {
    if (thing->still > 0) {
        thing->still -= h;
        thing->delay += h;
    } else
        thing->time += h;
    if (thing->body.asleep)
        return;
    body_drift(&thing->body, h);
    thing->pose = pose_sum(1, &thing->pose, h, &thing->velocity);
}

void thing_keep(Thing* thing) {
    if (thing->path_count == 0)
        return;
    memcpy(thing->good_x, thing->body.x, (size_t)thing->body.count * sizeof(real4));
    thing->good_time = thing->time;
    thing->good_still = thing->still;
    thing->good_delay = thing->delay;
    thing->good_pose = thing->pose;
}

void thing_put_back(Thing* thing) {
    if (thing->path_count == 0)
        return;
    memcpy(thing->body.x, thing->good_x, (size_t)thing->body.count * sizeof(real4));
    thing->time = thing->good_time;
    thing->still = thing->good_still;
    thing->delay = thing->good_delay;
    thing->pose = thing->good_pose;
    stand_still(thing);
}

/// Whether x, whose nearest point of the triangle is p on the side from corner k to the next, is over
/// the triangle on the other side of it.
static bool is_over_other_side(const Thing* thing, int triangle, int k, double4 p, double4 x) {
    const int* corner = thing->mesh.triangle[triangle];
    const int opposite = thing->across[triangle][k];
    if (opposite == NONE)
        return false;
    const double4 a = to_double4(thing->body.x[corner[k]]);
    const double4 side = to_double4(thing->body.x[corner[(k + 1) % 3]]) - a;
    double4 inward = to_double4(thing->body.x[opposite]) - a;
    inward -= ddot(inward, side) / ddot(side, side) * side;
    return ddot(x - p, inward) > cosine_min * dlength(x - p) * dlength(inward);
}

/// Whether x, whose nearest point of a triangle is this corner, is over an edge that begins there.
static bool is_over_edge(const Thing* thing, int point, double4 x) {
    const Mesh* mesh = &thing->mesh;
    const double4 p = to_double4(thing->body.x[point]);
    for (int k = mesh->point_edge_from[point]; k < mesh->point_edge_from[point + 1]; k++) {
        const int end = mesh_across(mesh, mesh->point_edge[k], point);
        const double4 edge = to_double4(thing->body.x[end]) - p;
        if (ddot(x - p, edge) > cosine_min * dlength(x - p) * dlength(edge))
            return true;
    }
    return false;
}

bool thing_is_nearest(const Thing* thing, int triangle, const double weight[3], double4 x) {
    const int* corner = thing->mesh.triangle[triangle];
    double4 p = {0};
    for (int k = 0; k < 3; k++)
        p += weight[k] * to_double4(thing->body.x[corner[k]]);
    for (int k = 0; k < 3; k++) {
        const bool here = weight[k] != 0, next = weight[(k + 1) % 3] != 0,
                   last = weight[(k + 2) % 3] != 0;
        if (here && next && !last)
            return !is_over_other_side(thing, triangle, k, p, x);
        if (here && !next && !last)
            return !is_over_edge(thing, corner[k], x);
    }
    return true;
}

void thing_close(Thing* thing) {
    body_free(&thing->body);
    mesh_free(&thing->mesh);
    free(thing->path);
    free(thing->start);
    free(thing->across);
    free(thing->good_x);
    *thing = (Thing){0};
}
