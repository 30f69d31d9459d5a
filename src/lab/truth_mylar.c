/// Two discs sewn together: the shape of a balloon that cannot stretch but wrinkles freely.
#include "lab/truth.h"

#include <math.h>

/// Integral of t^power/sqrt(1 - t^4) from 0 to 1, power even. t = sin(q) leaves
/// sin(q)^power/sqrt(1 + sin(q)^2), smooth and periodic, of which the midpoint rule has all digits
/// at 40 points.
static double lemniscate(int power) {
    enum { POINTS = 64 };
    const double pi = 3.14159265358979323846;
    double sum = 0;
    for (int i = 0; i < POINTS; i++) {
        const double t = sin((i + 0.5) * pi / (2 * POINTS));
        sum += pow(t, power) / sqrt(1 + t * t);
    }
    return sum * pi / (2 * POINTS);
}

TruthMylar truth_mylar(double disc) {
    const double pi = 3.14159265358979323846;
    const double r = disc / lemniscate(0);
    return (TruthMylar){
        .radius = r,
        .thickness = 2 * r * lemniscate(2),
        .volume = 2 * pi * r * r * r * lemniscate(4),
    };
}

double truth_mylar_tension(const TruthMylar* mylar, double pressure, double x) {
    return pressure * mylar->radius * mylar->radius / (2 * x);
}
