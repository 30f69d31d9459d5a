#include "contact/skins/crossings.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "contact/contacts.h"
#include "contact/skins/feature_pair.h"
#include "mesh/point_corners.h"

static void corners_of(const Body* body, int triangle, double4 corner[3]) {
    for (int k = 0; k < 3; k++)
        corner[k] = to_double4(body->x[body->mesh->triangle[triangle][k]]);
}

/// Whether an edge of the first triangle that has no corner of the second one pierces that.
static bool edge_pierces(const Body* first, int t, const Body* second, int u) {
    const int *a = first->mesh->triangle[t], *b = second->mesh->triangle[u];
    double4 corner[2][3];
    corners_of(first, t, corner[0]);
    corners_of(second, u, corner[1]);
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        const bool shared = first == second && (triangle_has(b, a[k]) || triangle_has(b, a[next]));
        if (!shared && feature_pierces(corner[0][k], corner[0][next], corner[1]))
            return true;
    }
    return false;
}

bool crossing_of(const Body* first, int t, const Body* second, int u) {
    return edge_pierces(first, t, second, u) || edge_pierces(second, u, first, t);
}

static BulletSkin* open_boxes(const Body* body) {
    return bullet_skin_open((const int(*)[3])body->mesh->triangle, body->mesh->triangle_count,
                            body->x, body->count);
}

/// Add the pairs of skins a and b that cross, up to `most` of all.
static void add_pairs(Crossings* crossings, const Body* const body[2], BulletSkin* const boxes[2],
                      const int skin[2], int most) {
    const int(*pair)[2];
    const int near = bullet_skin_near_triangles(boxes[0], boxes[1], 0, &pair);
    for (int k = 0; k < near && crossings->count < most; k++) {
        if (!crossing_of(body[0], pair[k][0], body[1], pair[k][1]))
            continue;
        if (crossings->count++ > 0)
            continue;
        for (int side = 0; side < 2; side++) {
            crossings->skin[side] = skin[side];
            crossings->triangle[side] = pair[k][side];
        }
    }
}

Crossings crossings_of_skin(const Body* body) {
    BulletSkin* boxes = open_boxes(body);
    Crossings crossings = {0};
    add_pairs(&crossings, (const Body* const[]){body, body}, (BulletSkin* const[]){boxes, boxes},
              (const int[]){0, 0}, INT_MAX);
    bullet_skin_close(boxes);
    return crossings;
}

bool crossings_any(const Body* first, const Body* second) {
    BulletSkin *a = open_boxes(first), *b = open_boxes(second);
    Crossings crossings = {0};
    add_pairs(&crossings, (const Body* const[]){first, second}, (BulletSkin* const[]){a, b},
              (const int[]){0, 1}, 1);
    bullet_skin_close(a);
    bullet_skin_close(b);
    return crossings.count > 0;
}

Crossings crossings_find(const Contacts* contacts, bool touching) {
    const int count = contacts->skin_count;
    BulletSkin** boxes = new_array(BulletSkin*, count);
    Crossings crossings = {0};
    for (int a = 0; a < count; a++)
        boxes[a] = open_boxes(contacts->skin[a].body);
    for (int a = 0; a < contacts->first_thing; a++)
        for (int b = a; b < count; b++)
            if (!touching || skin_pairs_may_touch(contacts, a, b))
                add_pairs(&crossings,
                          (const Body* const[]){contacts->skin[a].body, contacts->skin[b].body},
                          (BulletSkin* const[]){boxes[a], boxes[b]}, (const int[]){a, b}, INT_MAX);
    for (int a = 0; a < count; a++)
        bullet_skin_close(boxes[a]);
    free(boxes);
    return crossings;
}

bool crossings_left_out(const Contacts* contacts, int skin[2]) {
    const SkinPairs* pairs = &contacts->skin_pairs;
    for (skin[0] = 0; pairs->begun && skin[0] < contacts->skin_count; skin[0]++)
        for (skin[1] = skin[0]; skin[1] < contacts->skin_count; skin[1]++)
            if (pairs->list[skin[0] * contacts->skin_count + skin[1]].crossed)
                return true;
    return false;
}

void crossings_say(const Crossings* crossings, const char* model, const char* other_model,
                   char* text, size_t size) {
    const int first = crossings->skin[0], second = crossings->skin[1];
    char other[80] = "itself";
    if (first != second)
        snprintf(other, sizeof other, "balloons.%d (%s)", second, other_model);
    if (crossings->count == 0) {
        snprintf(
            text, size,
            "balloons.%d (%s) meets %s at points at the start, and may be across it; the two do "
            "not touch until they have come apart",
            first, model, other);
        return;
    }
    snprintf(
        text, size,
        "balloons.%d (%s) crosses %s at the start, %d pairs of triangles in all; what crosses does "
        "not touch until it has come apart",
        first, model, other, crossings->count);
}
