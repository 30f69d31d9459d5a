#include "contact/triangle_path.h"

static const double never = 2;
static const int bisections = 60; ///< halve [0, 1] to its last bit
static const double rim = 1e-9;   ///< [1] a path through an edge counts for both its triangles

/// Height of the point over the triangle's plane at time t, times twice the triangle's area.
static double height(double4 p, double4 dp, const double4 a[3], const double4 da[3], double t) {
    const double4 o = a[0] + t * da[0];
    return ddot(p + t * dp - o, dcross(a[1] + t * da[1] - o, a[2] + t * da[2] - o));
}

/// Whether the point is within the triangle's outline at time t, seen along its normal.
static bool within(double4 p, double4 dp, const double4 a[3], const double4 da[3], double t) {
    double4 corner[3];
    for (int k = 0; k < 3; k++)
        corner[k] = a[k] + t * da[k] - (p + t * dp);
    const double4 n = dcross(corner[1] - corner[0], corner[2] - corner[0]);
    const double area2 = ddot(n, n);
    for (int k = 0; k < 3; k++)
        if (ddot(n, dcross(corner[k], corner[(k + 1) % 3])) < -rim * area2)
            return false;
    return area2 > 0;
}

/// Where the derivative of the cubic c0 + c1 t + c2 t^2 + c3 t^3 vanishes inside (0, 1), in order.
static int turning_points(const double c[4], double at[2]) {
    int count = 0;
    const double a = 3 * c[3], b = 2 * c[2], d = c[1];
    double root[2] = {-1, -1};
    if (a == 0) {
        root[0] = b == 0 ? -1 : -d / b;
    } else if (b * b - 4 * a * d > 0) {
        const double q = -0.5 * (b + copysign(sqrt(b * b - 4 * a * d), b));
        root[0] = q / a;
        root[1] = q == 0 ? -1 : d / q;
    }
    if (root[0] > root[1]) {
        const double larger = root[0];
        root[0] = root[1];
        root[1] = larger;
    }
    for (int k = 0; k < 2; k++)
        if (root[k] > 0 && root[k] < 1)
            at[count++] = root[k];
    return count;
}

double triangle_crossing_time(double4 p, double4 dp, const double4 a[3], const double4 da[3]) {
    // the cubic through four of its values
    const double f0 = height(p, dp, a, da, 0), f1 = height(p, dp, a, da, 1.0 / 3);
    const double f2 = height(p, dp, a, da, 2.0 / 3), f3 = height(p, dp, a, da, 1);
    const double c[4] = {f0, (-11 * f0 + 18 * f1 - 9 * f2 + 2 * f3) / 2,
                         9 * (2 * f0 - 5 * f1 + 4 * f2 - f3) / 2,
                         9 * (-f0 + 3 * f1 - 3 * f2 + f3) / 2};
    double piece[4] = {0};
    const int turns = turning_points(c, piece + 1);
    piece[turns + 1] = 1;

    for (int k = 0; k <= turns; k++) {
        double low = piece[k], high = piece[k + 1];
        const double before = height(p, dp, a, da, low);
        if (before == 0 || before * height(p, dp, a, da, high) > 0)
            continue;
        for (int n = 0; n < bisections; n++) {
            const double middle = (low + high) / 2;
            *(before * height(p, dp, a, da, middle) > 0 ? &low : &high) = middle;
        }
        if (within(p, dp, a, da, high))
            return high;
    }
    return never;
}

double winding_number(const Mesh* mesh, const real4* x, double4 point) {
    double sum = 0;
    for (int t = 0; t < mesh->triangle_count; t++) {
        double4 r[3];
        double size[3];
        for (int k = 0; k < 3; k++) {
            r[k] = to_double4(x[mesh->triangle[t][k]]) - point;
            size[k] = dlength(r[k]);
        }
        const double volume = ddot(r[0], dcross(r[1], r[2]));
        const double shape = size[0] * size[1] * size[2] + ddot(r[0], r[1]) * size[2] +
                             ddot(r[1], r[2]) * size[0] + ddot(r[2], r[0]) * size[1];
        sum += 2 * atan2(volume, shape);
    }
    return sum / (4 * PI);
}
