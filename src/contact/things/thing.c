#include "contact/things/thing.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/point_corners.h"

static const double return_rate = 10; ///< [1/s] at most, to the path

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

void thing_make(Thing* thing, const Mesh* mesh, real friction, const PathPoint* path,
                int path_count) {
    const int count = mesh->point_count;
    *thing = (Thing){.mesh = *mesh,
                     .friction = friction,
                     .path_count = path_count,
                     .path = new_array(PathPoint, path_count),
                     .start = new_array(real4, count),
                     .across = new_array(int[3], mesh->triangle_count),
                     .good_x = new_array(real4, count)};
    body_make(&thing->body, &thing->mesh, &(Placement){.scale = 1}, INFINITY);
    memcpy(thing->start, thing->body.x, (size_t)count * sizeof(real4));
    for (int k = 0; k < path_count; k++)
        thing->path[k] = path[k];
    find_across(thing);
    thing_reset(thing);
}

double4 path_displacement(const PathPoint* first, int count, double t) {
    if (count == 0 || t <= first->at)
        return (double4){0};
    for (const PathPoint* to = first + 1; to < first + count; to++)
        if (t < to->at) {
            const double part = (t - to[-1].at) / (to->at - to[-1].at);
            return to[-1].position - first->position + part * (to->position - to[-1].position);
        }
    return first[count - 1].position - first->position;
}

static void stand_still(Thing* thing) {
    thing->body.asleep = true;
    thing->velocity = (double4){0};
    memset(thing->body.v, 0, (size_t)thing->body.count * sizeof(real4));
}

void thing_reset(Thing* thing) {
    thing->time = thing->still = thing->delay = 0;
    thing->displacement = (double4){0};
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
    const double rate = fmin(1 / h, return_rate);
    const double4 now = path_displacement(thing->path, thing->path_count, thing->time),
                  lag = now - thing->displacement,
                  along = path_displacement(thing->path, thing->path_count, thing->time + h) - now;
    // at rest a rounding remains as it is
    if (dlength(along) == 0 && dlength(lag) <= (double)REAL_EPSILON * body->size) {
        stand_still(thing);
        return;
    }
    thing->velocity = along / h + rate * lag;
    body->asleep = false;
    for (int i = 0; i < body->count; i++) {
        const double4 to = to_double4(thing->start[i]) + thing->displacement;
        body->v[i] = to_real4(thing->velocity + rate * (to - to_double4(body->x[i])));
    }
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
    thing->displacement += h * thing->velocity;
}

void thing_keep(Thing* thing) {
    if (thing->path_count == 0)
        return;
    memcpy(thing->good_x, thing->body.x, (size_t)thing->body.count * sizeof(real4));
    thing->good_time = thing->time;
    thing->good_still = thing->still;
    thing->good_delay = thing->delay;
    thing->good_displacement = thing->displacement;
}

void thing_put_back(Thing* thing) {
    if (thing->path_count == 0)
        return;
    memcpy(thing->body.x, thing->good_x, (size_t)thing->body.count * sizeof(real4));
    thing->time = thing->good_time;
    thing->still = thing->good_still;
    thing->delay = thing->good_delay;
    thing->displacement = thing->good_displacement;
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
