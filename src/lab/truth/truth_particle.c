/// Particles whose path is known: those at the corners of a cube.
#include "lab/truth/truth.h"

#include <math.h>

#include "base/fault.h"

/// A damped spring x'' + gamma x' + w2 x = 0 with gamma^2 < 4 w2, at rest at x0: x(t) [m].
static double spring(double w2, double gamma, double x0, double t) {
    const double swing2 = w2 - gamma * gamma / 4;
    ASSERT(swing2 > 0, "the spring must be damped so little that it swings");
    const double swing = sqrt(swing2);
    return exp(-gamma * t / 2) * (x0 * cos(swing * t) + gamma / 2 * x0 / swing * sin(swing * t));
}

TruthCube truth_cube_default(void) {
    return (TruthCube){
        .side = 2, .structural = 50, .shear = 10, .mass = 1e-3, .drag = 0.02, .amount = 1};
}

/// The square of the angular frequency, (2 ks + 4 kd)/m [1/s^2].
static double cube_w2(const TruthCube* cube) {
    // an edge grows by 2 u/sqrt(3) and pulls at 1/sqrt(3) along r; a diagonal by 2 sqrt(2/3) u and
    // pulls at sqrt(2/3); there are three of each at a corner
    return (2 * cube->structural + 4 * cube->shear) / cube->mass;
}

/// Outward force on each corner [N].
static double cube_push(const TruthCube* cube) {
    return 100 * cube->amount * sqrt(3) / 24;
}

/// Displacement of the corners at rest [m].
static double rest_growth(const TruthCube* cube) {
    return cube_push(cube) / (cube->mass * cube_w2(cube));
}

double truth_cube_rest(const TruthCube* cube) {
    return cube->side * sqrt(3) / 2 + rest_growth(cube);
}

double truth_cube_growth(const TruthCube* cube, double t) {
    // a damped spring about its new rest
    const double gamma = cube->drag / cube->mass, away = rest_growth(cube);
    return away + spring(cube_w2(cube), gamma, -away, t);
}
