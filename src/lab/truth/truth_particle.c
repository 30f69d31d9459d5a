/// Particles whose path is known: falling, rising, on a spring, in a chain, at the corners of a
/// cube.
#include "lab/truth/truth.h"

#include <math.h>

#include "base/real.h"
#include "base/fault.h"

double truth_fall(double gravity, double h, int n) {
    // v_n = -g h n, x_n = h (v_1 + … + v_n)
    return -gravity * h * h * n * (n + 1.0) / 2;
}

double truth_rise(double lift, double gravity, double mass, double drag, double h, int n) {
    // v' = (1 - c h/m) v + h (lift - g), a geometric series; springs cancel in the sum
    const double terminal = mass * (lift - gravity) / drag;
    return terminal * (1 - pow(1 - drag * h / mass, n));
}

double truth_spring(double w2, double gamma, double x0, double v0, double t) {
    const double swing2 = w2 - gamma * gamma / 4;
    ASSERT(swing2 > 0, "the spring must be damped so little that it swings");
    const double swing = sqrt(swing2);
    return exp(-gamma * t / 2) *
           (x0 * cos(swing * t) + (v0 + gamma / 2 * x0) / swing * sin(swing * t));
}

double truth_euler_invariant(double w2, double h, double x, double v) {
    return v * v / 2 + w2 * x * x / 2 - h * w2 * x * v / 2;
}

double truth_euler_frequency(double w, double h) {
    // the step's eigenvalues e^(+-i w' h) have the trace 2 cos(w' h) = 2 - w^2 h^2
    return 2 / h * asin(w * h / 2);
}

double truth_chain(double stiffness, double mass, int n, int j) {
    // particle i of mode j stands at sin(i j pi/(n+1))
    return 2 * sqrt(stiffness / mass) * sin(j * PI / (2 * (n + 1.0)));
}

TruthCube truth_cube_default(void) {
    return (TruthCube){
        .side = 2, .structural = 50, .shear = 10, .mass = 1e-3, .drag = 0.02, .amount = 1};
}

double truth_cube_w2(const TruthCube* cube) {
    // an edge grows by 2 u/sqrt(3) and pulls at 1/sqrt(3) along r; a diagonal by 2 sqrt(2/3) u and
    // pulls at sqrt(2/3); there are three of each at a corner
    return (2 * cube->structural + 4 * cube->shear) / cube->mass;
}

double truth_cube_push(const TruthCube* cube) {
    return 100 * cube->amount * sqrt(3) / 24;
}

/// How far the corners go out in the end [m].
static double rest_growth(const TruthCube* cube) {
    return truth_cube_push(cube) / (cube->mass * truth_cube_w2(cube));
}

double truth_cube_rest(const TruthCube* cube) {
    return cube->side * sqrt(3) / 2 + rest_growth(cube);
}

double truth_cube_growth(const TruthCube* cube, double t) {
    // a damped spring about its new rest
    const double gamma = cube->drag / cube->mass, away = rest_growth(cube);
    return away + truth_spring(truth_cube_w2(cube), gamma, -away, 0, t);
}
