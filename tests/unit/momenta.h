/// Momenta and kinetic energy of particles, and the sizes against which their changes are judged.
#ifndef BALLOON_TESTS_MOMENTA_H
#define BALLOON_TESTS_MOMENTA_H

#include "worlds.h"

typedef struct Momenta {
    double4 linear, angular;          ///< about the origin
    double linear_size, angular_size; ///< sums of |m v| and |r x m v|
    double kinetic;
} Momenta;

static inline void momenta_add(Momenta* sum, double mass, real4 x, real4 v) {
    const double4 p = mass * to_double4(v), l = dcross(to_double4(x), p);
    sum->linear += p;
    sum->angular += l;
    sum->linear_size += dlength(p);
    sum->angular_size += dlength(l);
    sum->kinetic += ddot(p, p) / (2 * mass);
}

/// Of all balloons.
static inline Momenta momenta_of(const World* world) {
    Momenta sum = {0};
    for (int b = 0; b < world->balloon_count; b++) {
        const Body* body = &world->balloon[b].body;
        for (int i = 0; i < body->count; i++)
            momenta_add(&sum, (double)body->mass[i], body->x[i], body->v[i]);
    }
    return sum;
}

/// The same within the share `tolerance` of their sizes.
static inline void assert_momenta(const Momenta* now, const Momenta* before, double tolerance) {
    assert_near(dlength(now->linear - before->linear), 0, tolerance * before->linear_size);
    assert_near(dlength(now->angular - before->angular), 0, tolerance * before->angular_size);
}

#endif
