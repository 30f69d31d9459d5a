/// The one scalar type of the state, so that precision is an axis of the chart.
///
/// src/ is compiled twice: `real` is float in build/balloon and double in build/balloon-double.
/// State is computed with + - * / and square root only, which IEEE 754 rounds the same everywhere,
/// so compilers and machines agree to the last bit. Reductions and time are double in both builds.
#ifndef BALLOON_BASE_REAL_H
#define BALLOON_BASE_REAL_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

#define PI 3.14159265358979323846

#ifdef BALLOON_DOUBLE
typedef double real;
#define REAL_NAME "double"
#define REAL_EPSILON DBL_EPSILON
#define REAL_MIN_POSITIVE DBL_MIN // normal and above 0
#define REAL_MAX DBL_MAX
#else
typedef float real;
#define REAL_NAME "float"
#define REAL_EPSILON FLT_EPSILON
#define REAL_MIN_POSITIVE FLT_MIN
#define REAL_MAX FLT_MAX
#endif

/// Whether the state can be computed with a number of a scene: forces and energies are products of
/// two such numbers, so its square must be finite and not round to 0.
static inline bool real_holds(double value) {
    const double square = value * value;
    return value == 0 || (square >= (double)REAL_MIN_POSITIVE && square <= (double)REAL_MAX);
}

static inline real real_sqrt(real a) {
#ifdef BALLOON_DOUBLE
    return sqrt(a);
#else
    return sqrtf(a);
#endif
}

static inline real real_min(real a, real b) {
    return a < b ? a : b;
}

static inline real real_max(real a, real b) {
    return a > b ? a : b;
}

#endif
