#include "mesh/shapes/circle.h"

static const double EIGHTH = 0.78539816339744830962; ///< pi / 4, an eighth of the way around
enum { TERMS = 18 };                                 ///< pi/4 to the 19th over 19! is below 1e-19

/// Taylor series of both, in Horner's form: 1 - q/(2 3) (1 - q/(4 5) (1 - …)), q the angle squared.
static CirclePoint series(double angle) {
    const double q = angle * angle;
    double sine = 1;
    double cosine = 1;
    for (int j = TERMS; j > 0; j -= 2) {
        sine = 1 - q * sine / (j * (j + 1));
        cosine = 1 - q * cosine / ((j - 1) * j);
    }
    return (CirclePoint){.cosine = cosine, .sine = angle * sine};
}

CirclePoint circle_point(int k, int n) {
    // the angle is reduced to an eighth of the circle in integers, so that all eighths are equal
    const long eighth = 8L * k / n;
    const long rest = 8L * k % n;
    CirclePoint p;
    if (eighth % 2 == 0) {
        p = series(EIGHTH * (double)rest / n);
    } else {
        const CirclePoint mirrored = series(EIGHTH * (double)(n - rest) / n);
        p = (CirclePoint){.cosine = mirrored.sine, .sine = mirrored.cosine};
    }
    for (long quarter = eighth / 2; quarter > 0; quarter--)
        p = (CirclePoint){.cosine = -p.sine, .sine = p.cosine};
    return p;
}
