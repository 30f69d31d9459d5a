/// Two discs sewn together: the shape of a balloon that cannot stretch and wrinkles freely.
#include "lab/truth/truth.h"

#include <math.h>

#include "base/real.h"

/// Integral of t^power/sqrt(1 - t^4) from 0 to 1, power even. t = sin(q) leaves
/// sin(q)^power/sqrt(1 + sin(q)^2), smooth and periodic, so that the midpoint rule with 40 points
/// is exact to rounding.
static double lemniscate(int power) {
    enum { POINTS = 64 };
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
        const double t = sin((i + 0.5) * PI / (2 * POINTS));
        sum += pow(t, power) / sqrt(1 + t * t);
    }
    return sum * PI / (2 * POINTS);
}

TruthMylar truth_mylar(double disc) {
    const double r = disc / lemniscate(0);
    return (TruthMylar){
        .radius = r,
        .thickness = 2 * r * lemniscate(2),
        .volume = 2 * PI * r * r * r * lemniscate(4),
    };
}
