/// The loops over a skin's elements, made by each material for its own law.
///
/// A material's file defines
///
///     static inline Law law(const real k[2], real t, real I, real D);
///
/// before it includes this, and gets add_elements, stiffen_elements and bound_elements. The second
/// derivative is taken in the principal frame of C: with s1, s2 the principal stretches, u1, u2 the
/// directions to which they go and u3 the normal, the derivative of the stress by F is
///
///     stretching   [W11 W12; W12 W22]            on u1 r1, u2 r2
///     shearing     [2 w1, b; b, 2 w1]            on u2 r1, u1 r2,  b = -2 w2 s1 s2
///     out of plane S1, S2                        on u3 r1, u3 r2
///
///     Wii = Si + 4 si^2 (w11 + 2 w12 sj^2 + w22 sj^4),  Si = 2 (w1 + w2 sj^2)
///     W12 = 4 s1 s2 (w11 + w12 (s1^2 + s2^2) + w22 s1^2 s2^2 + w2)
///
/// which needs no division by differences of stretches, and is made positive definite block by
/// block (after J. Teran et al., Robust quasistatic finite elements and flesh simulation, 2005).
#ifndef BALLOON_FORCE_MEMBRANE_KERNEL_H
#define BALLOON_FORCE_MEMBRANE_KERNEL_H

#include "body/membrane.h"

/// First and second derivatives of W by I and D. [Pa]
typedef struct Law {
    real w1, w2, w11, w12, w22;
} Law;

static inline Law law(const real k[2], real t, real I, real D);

/// Deformation of an element: columns of F, and its invariants.
typedef struct Deformation {
    real4 f1, f2;
    real c11, c12, c22;
    real D;
    Law law;
} Deformation;

static inline Deformation deform(const Membrane* membrane, const real k[2], const real4* x, int e) {
    const int* c = membrane->corner[e];
    const real4 r = membrane->rest[e];
    const real4 e1 = x[c[1]] - x[c[0]], e2 = x[c[2]] - x[c[0]];
    Deformation d = {.f1 = r[0] * e1, .f2 = r[1] * e1 + r[2] * e2};
    d.c11 = dot(d.f1, d.f1);
    d.c12 = dot(d.f1, d.f2);
    d.c22 = dot(d.f2, d.f2);
    const real4 normal = cross(d.f1, d.f2); // D without the cancellation of c11 c22 - c12^2
    d.D = dot(normal, normal);
    d.law = law(k, membrane->thickness[e] / membrane->first[e], d.c11 + d.c22, d.D);
    return d;
}

static void add_elements(const Membrane* membrane, const real4* restrict x, real4* restrict f) {
    const real k[2] = {(real)membrane->constant[0], (real)membrane->constant[1]};
    for (int e = 0; e < membrane->count; e++) {
        const Deformation d = deform(membrane, k, x, e);
        const real s11 = 2 * (d.law.w1 + d.law.w2 * d.c22);
        const real s22 = 2 * (d.law.w1 + d.law.w2 * d.c11);
        const real s12 = -2 * d.law.w2 * d.c12;

        // stress P = F S, then by the edges, which are what F is made of
        const real4 p1 = s11 * d.f1 + s12 * d.f2, p2 = s12 * d.f1 + s22 * d.f2;
        const real4 r = membrane->rest[e];
        const real4 g1 = (r[3] * r[0]) * p1 + (r[3] * r[1]) * p2, g2 = (r[3] * r[2]) * p2;
        const int* c = membrane->corner[e];
        f[c[0]] += g1 + g2;
        f[c[1]] -= g1;
        f[c[2]] -= g2;
    }
}

/// The second derivative in the principal frame, by number.
typedef struct Principal {
    real cosine, sine; ///< of the first principal direction r1 at rest
    real s1, s2;       ///< principal stretches, s1 >= s2
    real w11, w12, w22;
    real shear, cross; ///< 2 w1, b
    real out1, out2;   ///< S1, S2
} Principal;

static inline Principal principal_of(const Deformation* d) {
    // eigenvalues and first eigenvector of C, by half angles: no trigonometry
    const real mean = (d->c11 + d->c22) / 2, half = (d->c11 - d->c22) / 2;
    const real radius = real_sqrt(half * half + d->c12 * d->c12);
    Principal p = {.cosine = 1};
    if (radius > 0) { // the larger of the two first, the other from their product
        const real larger = real_sqrt((1 + real_max(half, -half) / radius) / 2);
        const real smaller = d->c12 / (2 * radius * larger);
        p.cosine = half >= 0 ? larger : smaller;
        p.sine = half >= 0 ? smaller : larger;
    }
    const real a = mean + radius, b = a > 0 ? d->D / a : 0; // squared stretches, without cancelling
    p.s1 = real_sqrt(a);
    p.s2 = real_sqrt(b);

    const Law* l = &d->law;
    p.out1 = 2 * (l->w1 + l->w2 * b);
    p.out2 = 2 * (l->w1 + l->w2 * a);
    p.w11 = p.out1 + 4 * a * (l->w11 + 2 * l->w12 * b + l->w22 * b * b);
    p.w22 = p.out2 + 4 * b * (l->w11 + 2 * l->w12 * a + l->w22 * a * a);
    p.w12 = 4 * p.s1 * p.s2 * (l->w11 + l->w12 * (a + b) + l->w22 * a * b + l->w2);
    p.shear = 2 * l->w1;
    p.cross = -2 * l->w2 * p.s1 * p.s2;
    return p;
}

/// Take the negative eigenvalue out of a symmetric block [a b; b c].
static inline void clamp_block(real* a, real* b, real* c) {
    const real mean = (*a + *c) / 2, half = (*a - *c) / 2;
    const real radius = real_sqrt(half * half + *b * *b);
    if (mean - radius >= 0)
        return;
    // what is left is the positive eigenvalue times its direction, squared
    const real top = real_max(mean + radius, 0);
    const real cosine = radius > 0 ? half / radius : 0, sine = radius > 0 ? *b / radius : 0;
    *a = top * (1 + cosine) / 2;
    *c = top * (1 - cosine) / 2;
    *b = top * sine / 2;
}

static inline void make_positive(Principal* p) {
    clamp_block(&p->w11, &p->w12, &p->w22);
    real shear = p->shear, other = p->shear;
    clamp_block(&shear, &p->cross, &other);
    p->shear = shear;
    p->out1 = real_max(p->out1, 0);
    p->out2 = real_max(p->out2, 0);
}

/// block += factor a b^T, as columns.
static inline void outer(real4 block[3], real factor, real4 a, real4 b) {
    for (int c = 0; c < 3; c++)
        block[c] += (factor * b[c]) * a;
}

/// Blocks by the principal directions at rest: by = r_i r_j.
static inline void principal_blocks(const Deformation* d, const Principal* p, real4 b11[3],
                                    real4 b12[3], real4 b22[3]) {
    const real4 g1 = p->cosine * d->f1 + p->sine * d->f2, g2 = p->cosine * d->f2 - p->sine * d->f1;
    const real4 zero = {0, 0, 0, 0};
    const real4 u1 = p->s1 > 0 ? g1 / p->s1 : zero;
    const real4 normal = cross(g1, g2);
    const real area = length(normal);
    const real4 u3 = area > 0 ? normal / area : zero;
    const real4 u2 = cross(u3, u1);
    outer(b11, p->w11, u1, u1);
    outer(b11, p->shear, u2, u2);
    outer(b11, p->out1, u3, u3);
    outer(b22, p->w22, u2, u2);
    outer(b22, p->shear, u1, u1);
    outer(b22, p->out2, u3, u3);
    outer(b12, p->w12, u1, u2);
    outer(b12, p->cross, u2, u1);
}

/// The transpose of three columns, spare lanes zero.
static inline void transpose(const real4 block[3], real4 out[3]) {
    for (int c = 0; c < 3; c++)
        out[c] = (real4){block[0][c], block[1][c], block[2][c], 0};
}

static void stiffen_elements(Membrane* membrane, const real4* restrict x, bool project) {
    const real k[2] = {(real)membrane->constant[0], (real)membrane->constant[1]};
    for (int e = 0; e < membrane->count; e++) {
        const Deformation d = deform(membrane, k, x, e);
        Principal p = principal_of(&d);
        if (project)
            make_positive(&p);
        real4 b11[3] = {{0}}, b12[3] = {{0}}, b21[3], b22[3] = {{0}};
        principal_blocks(&d, &p, b11, b12, b22);
        transpose(b12, b21);

        // F r_i = q_i1 e1 + q_i2 e2
        const real4 r = membrane->rest[e];
        const real q11 = p.cosine * r[0] + p.sine * r[1], q12 = p.sine * r[2];
        const real q21 = p.cosine * r[1] - p.sine * r[0], q22 = p.cosine * r[2];
        Stiffness* s = &membrane->stiffness[e];
        for (int c = 0; c < 3; c++) {
            s->k11[c] =
                r[3] * (q11 * q11 * b11[c] + q11 * q21 * (b12[c] + b21[c]) + q21 * q21 * b22[c]);
            s->k12[c] = r[3] * (q11 * q12 * b11[c] + q11 * q22 * b12[c] + q21 * q12 * b21[c] +
                                q21 * q22 * b22[c]);
            s->k22[c] =
                r[3] * (q12 * q12 * b11[c] + q12 * q22 * (b12[c] + b21[c]) + q22 * q22 * b22[c]);
        }
        transpose(s->k12, s->k21);
    }
}

/// An element alone on its share of the mass is never slower than the skin: w^2 <= the largest over
/// elements of 3 eta / rho times the larger eigenvalue of the shape functions' gradients G G^T,
/// with eta the largest eigenvalue of the second derivative by F.
static double bound_elements(const Membrane* membrane, const real4* restrict x) {
    const real k[2] = {(real)membrane->constant[0], (real)membrane->constant[1]};
    double most = 0;
    for (int e = 0; e < membrane->count; e++) {
        const Deformation d = deform(membrane, k, x, e);
        const Principal p = principal_of(&d);
        const real half = (p.w11 - p.w22) / 2;
        const real plane = (p.w11 + p.w22) / 2 + real_sqrt(half * half + p.w12 * p.w12);
        const real shear = p.shear + real_max(p.cross, -p.cross);
        const double eta =
            (double)real_max(real_max(plane, shear), p.out1 > p.out2 ? p.out1 : p.out2);

        // gradients of the corners: (r0, r1), (0, r2) and less their sum
        const double r0 = (double)membrane->rest[e][0], r1 = (double)membrane->rest[e][1],
                     r2 = (double)membrane->rest[e][2], sum = r1 + r2;
        const double gxx = 2 * r0 * r0, gyy = r1 * r1 + r2 * r2 + sum * sum, gxy = r0 * (r1 + sum);
        const double steep = (gxx + gyy) / 2 + sqrt((gxx - gyy) * (gxx - gyy) / 4 + gxy * gxy);
        most = fmax(most, eta * steep);
    }
    return 3 * most / membrane->rubber.density;
}

#endif
