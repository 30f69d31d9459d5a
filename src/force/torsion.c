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

static void stiffen(Body* body, bool project) {
    body->torsion.project = project;
}

/// How one end's part of the bend's gradient, g = (n - (n.u) u) / a, changes as u, n and a do.
static real4 slope_change(real4 n, real4 dn, real4 u, real4 du, real4 g, real a, real da) {
    return (dn - (dot(dn, u) + dot(n, du)) * u - dot(n, u) * du - da * g) / a;
}

/// K d = k (db/dx)(db/dx . d) + k (b - rest) (d2b/dx2) d; the second part has both signs.
static void product(const Body* body, double factor, const real4* d, real4* out) {
    const Torsion* torsion = &body->torsion;
    const real stiffness = (real)factor * torsion->stiffness;
    for (int t = 0; t < torsion->count; t++) {
        const int p = torsion->path[t][0], m = torsion->path[t][1], q = torsion->path[t][2];
        const real4 dp = body->x[p] - body->x[m], dq = body->x[q] - body->x[m];
        const real a = length(dp), c = length(dq);
        if (!(a > 0 && c > 0))
            continue;
        const real4 u = dp / a, w = dq / c;
        const real b = length(u + w);
        if (!(b > 0))
            continue;
        const real4 n = (u + w) / b;
        const real4 gp = (n - dot(n, u) * u) / a, gq = (n - dot(n, w) * w) / c;
        const real4 change_p = d[p] - d[m], change_q = d[q] - d[m];
        const real db = dot(gp, change_p) + dot(gq, change_q);
        real4 kp = (stiffness * db) * gp, kq = (stiffness * db) * gq;
        if (!torsion->project) {
            const real da = dot(u, change_p), dc = dot(w, change_q);
            const real4 du = (change_p - da * u) / a, dw = (change_q - dc * w) / c;
            const real4 dn = (du + dw - db * n) / b;
            const real over = stiffness * (b - torsion->rest[t]);
            kp += over * slope_change(n, dn, u, du, gp, a, da);
            kq += over * slope_change(n, dn, w, dw, gq, c, dc);
        }
        out[p] += kp;
        out[q] += kq;
        out[m] -= kp + kq;
    }
}

const Force force_torsion = {
    .name = "torsion",
    .about = "springs on the angle of two-edge paths",
    .present = present,
    .add = add,
    .energy = energy,
    .bound = bound,
    .stiffen = stiffen,
    .product = product,
    .internal = true,
};
