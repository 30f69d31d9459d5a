/// Torsion: E = k (b - rest)^2 / 2 with the bend b = |u + w|, u and w the unit vectors from the
/// middle of a path to its two ends (body/torsion.h). With n = (u + w) / b and a the length of an
/// edge, db/dp = (n - (n.u) u) / a; the middle takes the opposite of both ends.
#include "force/force.h"

static bool present(const Body* body) {
    return body->torsion.count > 0;
}

static void add(Body* body) {
    const Torsion* torsion = &body->torsion;
    for (int t = 0; t < torsion->count; t++) {
        const int p = torsion->path[t][0], m = torsion->path[t][1], q = torsion->path[t][2];
        const real4 dp = body->x[p] - body->x[m], dq = body->x[q] - body->x[m];
        const real a = length(dp), c = length(dq);
        if (!(a > 0 && c > 0))
            continue;
        const real4 u = dp / a, w = dq / c;
        const real b = length(u + w);
        if (!(b > 0)) // straight: every direction of bending is as good, none is pushed
            continue;
        const real4 n = (u + w) / b;
        const real pull = -torsion->stiffness * (b - torsion->rest[t]);
        const real4 fp = (pull / a) * (n - dot(n, u) * u);
        const real4 fq = (pull / c) * (n - dot(n, w) * w);
        body->f[p] += fp;
        body->f[q] += fq;
        body->f[m] -= fp + fq;
    }
}

static double energy(const Body* body) {
    const Torsion* torsion = &body->torsion;
    double sum = 0;
    for (int t = 0; t < torsion->count; t++) {
        const double4 m = to_double4(body->x[torsion->path[t][1]]);
        const double4 dp = to_double4(body->x[torsion->path[t][0]]) - m;
        const double4 dq = to_double4(body->x[torsion->path[t][2]]) - m;
        const double b = dlength(dp / dlength(dp) + dq / dlength(dq));
        const double over = b - (double)torsion->rest[t];
        sum += 0.5 * (double)torsion->stiffness * over * over;
    }
    return sum;
}

static double bound(const Body* body) {
    return body->torsion.bound;
}

const Force force_torsion = {
    .name = "torsion",
    .about = "springs on the angle of two-edge paths",
    .present = present,
    .add = add,
    .energy = energy,
    .bound = bound,
    .internal = true,
};
