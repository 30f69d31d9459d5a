#include "contact/skins/crossings.h"

#include <limits.h>
#include <stdlib.h>

#include "base/memory.h"
#include "contact/contacts.h"
#include "contact/skins/feature_pair.h"

bool crossing_shares(const int a[3], int point) {
    return a[0] == point || a[1] == point || a[2] == point;
}

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
        const bool shared =
            first == second && (crossing_shares(b, a[k]) || crossing_shares(b, a[next]));
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

/// Pairs that cross, up to `most` of them.
static int count_pairs(const Body* first, BulletSkin* a, const Body* second, const BulletSkin* b,
                       int most) {
    const int(*pair)[2];
    const int near = bullet_skin_near_triangles(a, b, 0, &pair);
    int crossings = 0;
    for (int k = 0; k < near && crossings < most; k++)
        crossings += crossing_of(first, pair[k][0], second, pair[k][1]);
    return crossings;
}

bool crossings_any(const Body* first, const Body* second) {
    BulletSkin *a = open_boxes(first), *b = open_boxes(second);
    const bool any = count_pairs(first, a, second, b, 1) > 0;
    bullet_skin_close(a);
    bullet_skin_close(b);
    return any;
}

int crossings_count(const Contacts* contacts) {
    const int count = contacts->skin_count;
    BulletSkin** skin = new_array(BulletSkin*, count);
    int crossings = 0;
    for (int a = 0; a < count; a++)
        skin[a] = open_boxes(contacts->skin[a].body);
    for (int a = 0; a < contacts->first_thing; a++)
        for (int b = a; b < count; b++)
            crossings += count_pairs(contacts->skin[a].body, skin[a], contacts->skin[b].body,
                                     skin[b], INT_MAX);
    for (int a = 0; a < count; a++)
        bullet_skin_close(skin[a]);
    free(skin);
    return crossings;
}
