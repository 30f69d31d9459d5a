/// Crossings counted by a program of the tests' own, exactly: the signs of volumes in 113 bits.
#ifndef BALLOON_TESTS_CROSSINGS_H
#define BALLOON_TESTS_CROSSINGS_H

#include "worlds.h"

typedef __float128 Exact;

static inline Exact volume(real4 a, real4 b, real4 c, real4 d) {
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
static inline bool pierces(real4 a, real4 b, const real4 c[3]) {
    if (!(volume(a, c[0], c[1], c[2]) * volume(b, c[0], c[1], c[2]) < 0))
        return false;
    const Exact side[3] = {volume(a, b, c[0], c[1]), volume(a, b, c[1], c[2]),
                           volume(a, b, c[2], c[0])};
    return (side[0] > 0 && side[1] > 0 && side[2] > 0) ||
           (side[0] < 0 && side[1] < 0 && side[2] < 0);
}

static inline bool boxes_meet(const real4 a[3], const real4 b[3]) {
    for (int k = 0; k < 3; k++) {
        const real low_a = fmin(a[0][k], fmin(a[1][k], a[2][k])),
                   high_a = fmax(a[0][k], fmax(a[1][k], a[2][k])),
                   low_b = fmin(b[0][k], fmin(b[1][k], b[2][k])),
                   high_b = fmax(b[0][k], fmax(b[1][k], b[2][k]));
        if (low_a > high_b || low_b > high_a)
            return false;
    }
    return true;
}

static inline void corners(const Body* body, int t, real4 x[3]) {
    for (int k = 0; k < 3; k++)
        x[k] = body->x[body->mesh->triangle[t][k]];
}

static inline bool share(const Body* a, int t, const Body* b, int u) {
    for (int j = 0; a == b && j < 3; j++)
        for (int k = 0; k < 3; k++)
            if (a->mesh->triangle[t][j] == b->mesh->triangle[u][k])
                return true;
    return false;
}

/// Pairs of triangles without a common corner that cross, of two skins or of one.
static inline int crossings_of(const Body* a, const Body* b) {
    int count = 0;
    for (int t = 0; t < a->mesh->triangle_count; t++)
        for (int u = a == b ? t + 1 : 0; u < b->mesh->triangle_count; u++) {
            real4 p[3], q[3];
            corners(a, t, p);
            corners(b, u, q);
            bool any = false;
            if (boxes_meet(p, q) && !share(a, t, b, u))
                for (int k = 0; k < 3; k++)
                    any |= pierces(p[k], p[(k + 1) % 3], q) || pierces(q[k], q[(k + 1) % 3], p);
            count += any;
        }
    return count;
}

/// Those of all skins, each with itself and the others.
static inline int crossings(const World* world) {
    int count = 0;
    for (int i = 0; i < world->balloon_count; i++)
        for (int j = i; j < world->balloon_count; j++)
            count += crossings_of(&world->balloon[i].body, &world->balloon[j].body);
    return count;
}

#endif
