/// Vectors of space: x, y, z and one spare lane, as the compiler's own vector type, so that
/// `a + b`, `s * a` and `a[0]` need no functions and load in one instruction.
///
///     real4    a particle's position, velocity or force, in the precision of the build
///     double4  geometry that is computed once or summed up, in double in both builds
///
/// The spare lane is zero in every array that this program keeps. Sums over lanes run in the order
/// x, y, z, so that every compiler gives the same bits.
#ifndef BALLOON_BASE_VEC_H
#define BALLOON_BASE_VEC_H

#include "base/real.h"

typedef real real4 __attribute__((vector_size(4 * sizeof(real))));
typedef double double4 __attribute__((vector_size(4 * sizeof(double))));

enum { LANES = 8 }; ///< numbers in a group of an array that kernels read (base/lanes.h)

static inline real dot(real4 a, real4 b) {
    const real4 p = a * b;
    return p[0] + p[1] + p[2];
}

static inline real4 cross(real4 a, real4 b) {
    const real4 c = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0], 0};
    return c; // by name, because C++ has no compound literals
}

static inline real length(real4 a) {
    return real_sqrt(dot(a, a));
}

static inline double ddot(double4 a, double4 b) {
    const double4 p = a * b;
    return p[0] + p[1] + p[2];
}

static inline double4 dcross(double4 a, double4 b) {
    const double4 c = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                       a[0] * b[1] - a[1] * b[0], 0};
    return c;
}

static inline double dlength(double4 a) {
    return sqrt(ddot(a, a));
}

static inline double4 to_double4(real4 a) {
    return __builtin_convertvector(a, double4);
}

static inline real4 to_real4(double4 a) {
    return __builtin_convertvector(a, real4);
}

#endif
