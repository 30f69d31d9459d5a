#include "lab/bench/exact_crossings.h"

#include <stdlib.h>

#include "base/memory.h"

__extension__ typedef __float128 Exact;

static Exact volume(real4 a, real4 b, real4 c, real4 d) {
    Exact u[3], v[3], w[3];
    for (int k = 0; k < 3; k++) {
        u[k] = (Exact)a[k] - (Exact)d[k];
        v[k] = (Exact)b[k] - (Exact)d[k];
        w[k] = (Exact)c[k] - (Exact)d[k];
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
}

/// Whether segment (a, b) passes through the inside of triangle c.
static bool pierces(real4 a, real4 b, const real4 c[3]) {
    const Exact from = volume(a, c[0], c[1], c[2]), to = volume(b, c[0], c[1], c[2]);
    if (!((from < 0 && to > 0) || (from > 0 && to < 0)))
        return false;
    const Exact side[3] = {volume(a, b, c[0], c[1]), volume(a, b, c[1], c[2]),
                           volume(a, b, c[2], c[0])};
    return (side[0] > 0 && side[1] > 0 && side[2] > 0) ||
           (side[0] < 0 && side[1] < 0 && side[2] < 0);
}

/// A triangle with its box.
typedef struct Boxed {
    int number;
    real low[3], high[3];
} Boxed;

static int compare(const void* p, const void* q) {
    const Boxed *a = p, *b = q;
    if (a->low[0] != b->low[0])
        return a->low[0] < b->low[0] ? -1 : 1;
    return a->number - b->number;
}

/// In rising order of the low ends along x.
static Boxed* sorted_boxes(const Body* body) {
    const int count = body->mesh->triangle_count;
    Boxed* box = new_array(Boxed, count + 1);
    for (int t = 0; t < count; t++) {
        box[t].number = t;
        for (int k = 0; k < 3; k++) {
            const int* corner = body->mesh->triangle[t];
            const real p = body->x[corner[0]][k], q = body->x[corner[1]][k],
                       r = body->x[corner[2]][k];
            box[t].low[k] = real_min(p, real_min(q, r));
            box[t].high[k] = real_max(p, real_max(q, r));
        }
    }
    qsort(box, (size_t)count, sizeof *box, compare);
    return box;
}

static bool boxes_meet(const Boxed* a, const Boxed* b) {
    for (int k = 0; k < 3; k++)
        if (a->low[k] > b->high[k] || b->low[k] > a->high[k])
            return false;
    return true;
}

static bool have_common_corner(const int a[3], const int b[3]) {
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            if (a[j] == b[k])
                return true;
    return false;
}

static bool triangles_cross(const Body* a, int t, const Body* b, int u) {
    const int *corner = a->mesh->triangle[t], *other = b->mesh->triangle[u];
    if (a == b && have_common_corner(corner, other))
        return false;
    real4 p[3], q[3];
    for (int k = 0; k < 3; k++) {
        p[k] = a->x[corner[k]];
        q[k] = b->x[other[k]];
    }
    for (int k = 0; k < 3; k++)
        if (pierces(p[k], p[(k + 1) % 3], q) || pierces(q[k], q[(k + 1) % 3], p))
            return true;
    return false;
}

int exact_crossings(const Body* a, const Body* b) {
    Boxed *first = sorted_boxes(a), *second = sorted_boxes(b);
    int count = 0, from = 0;
    double widest = 0; // along x, of the second skin's boxes
    for (int u = 0; u < b->mesh->triangle_count; u++)
        widest = fmax(widest, (double)(second[u].high[0] - second[u].low[0]));
    for (int t = 0; t < a->mesh->triangle_count; t++) {
        while (from < b->mesh->triangle_count &&
               (double)second[from].low[0] < (double)first[t].low[0] - 1.001 * widest)
            from++;
        for (int u = from; u < b->mesh->triangle_count && second[u].low[0] <= first[t].high[0]; u++)
            if (boxes_meet(&first[t], &second[u]) &&
                !(a == b && second[u].number <= first[t].number))
                count += triangles_cross(a, first[t].number, b, second[u].number);
    }
    free(first);
    free(second);
    return count;
}

int exact_crossings_of_world(const World* world) {
    int count = 0;
    for (int i = 0; i < world->balloon_count; i++) {
        const Body* body = &world->balloon[i].body;
        for (int j = i; j < world->balloon_count; j++)
            count += exact_crossings(body, &world->balloon[j].body);
        for (int k = 0; k < world->thing_count; k++)
            count += exact_crossings(body, &world->thing[k].body);
    }
    return count;
}
