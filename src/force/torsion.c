/// Torsion: E = k (b - rest)^2 / 2 with the bend b = |u + w|, u and w the unit vectors from the
/// middle of a path to its two ends (body/torsion.h). With n = (u + w) / b and a the length of an
/// edge, db/dp = (n - (n.u) u) / a; the middle takes the opposite of both ends.
#include "force/force.h"

static bool present(const Body* body) {
    return body->torsion.count > 0;
}

/// The geometry of a bent path.
typedef struct Bend {
    int p, m, q;
    real a, c, b;
    real4 u, w, n;
} Bend;

/// False if the gradient is undefined: an edge has no length, or the path is straight.
static bool bend_of(const Body* body, const int path[3], Bend* at) {
    at->p = path[0], at->m = path[1], at->q = path[2];
    const real4 dp = body->x[at->p] - body->x[at->m], dq = body->x[at->q] - body->x[at->m];
    at->a = length(dp), at->c = length(dq);
    if (!(at->a > 0 && at->c > 0))
        return false;
    at->u = dp / at->a, at->w = dq / at->c;
    at->b = length(at->u + at->w);
    if (!(at->b > 0))
        return false;
    at->n = (at->u + at->w) / at->b;
    return true;
}

static void add(Body* body) {
    const Torsion* torsion = &body->torsion;
    for (int t = 0; t < torsion->count; t++) {
        Bend at;
        if (!bend_of(body, torsion->path[t], &at))
            continue;
        const real pull = -torsion->stiffness * (at.b - torsion->rest[t]);
        const real4 fp = (pull / at.a) * (at.n - dot(at.n, at.u) * at.u);
        const real4 fq = (pull / at.c) * (at.n - dot(at.n, at.w) * at.w);
        body->f[at.p] += fp;
        body->f[at.q] += fq;
        body->f[at.m] -= fp + fq;
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

static void update_tangent(Body* body, bool project) {
    body->torsion.project = project;
}

/// The derivative of g = (n - (n.u) u) / a, the gradient of the bend at one end, along a
/// displacement.
static real4 slope_change(real4 n, real4 dn, real4 u, real4 du, real4 g, real a, real da) {
    return (dn - (dot(dn, u) + dot(n, du)) * u - dot(n, u) * du - da * g) / a;
}

/// K d = k (db/dx)(db/dx . d) + k (b - rest) (d2b/dx2) d; the second part has both signs.
static void product(const Body* body, double factor, const real4* d, real4* out) {
    const Torsion* torsion = &body->torsion;
    const real stiffness = (real)factor * torsion->stiffness;
    for (int t = 0; t < torsion->count; t++) {
        Bend at;
        if (!bend_of(body, torsion->path[t], &at))
            continue;
        const real4 n = at.n, u = at.u, w = at.w;
        const real4 gp = (n - dot(n, u) * u) / at.a, gq = (n - dot(n, w) * w) / at.c;
        const real4 change_p = d[at.p] - d[at.m], change_q = d[at.q] - d[at.m];
        const real db = dot(gp, change_p) + dot(gq, change_q);
        real4 kp = (stiffness * db) * gp, kq = (stiffness * db) * gq;
        if (!torsion->project) {
            const real da = dot(u, change_p), dc = dot(w, change_q);
            const real4 du = (change_p - da * u) / at.a, dw = (change_q - dc * w) / at.c;
            const real4 dn = (du + dw - db * n) / at.b;
            const real over = stiffness * (at.b - torsion->rest[t]);
            kp += over * slope_change(n, dn, u, du, gp, at.a, da);
            kq += over * slope_change(n, dn, w, dw, gq, at.c, dc);
        }
        out[at.p] += kp;
        out[at.q] += kq;
        out[at.m] -= kp + kq;
    }
}

const Force force_torsion = {
    .name = "torsion",
    .about = "springs on the angle of two-edge paths",
    .present = present,
    .add = add,
    .energy = energy,
    .bound = bound,
    .update_tangent = update_tangent,
    .product = product,
    .elastic = true,
};
