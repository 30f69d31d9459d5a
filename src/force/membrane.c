/// The rubber skin: E = sum over elements of h0 A0 W(tr C, det C), body/membrane.h and the table of
/// materials. On an undeformed skin no element pulls, and net force and torque always vanish.
#include "force/force.h"
#include "force/material.h"

static bool present(const Body* body) {
    return body->membrane.count > 0;
}

static void add(Body* body) {
    body->membrane.rubber.material->add(&body->membrane, body->x, body->f);
}

static double energy(const Body* body) {
    const Membrane* membrane = &body->membrane;
    const Material* material = membrane->rubber.material;
    double sum = 0;
    for (int e = 0; e < membrane->count; e++) {
        const int* c = membrane->corner[e];
        const double4 a = to_double4(body->x[c[0]]), rest = to_double4(membrane->rest[e]);
        const double4 e1 = to_double4(body->x[c[1]]) - a, e2 = to_double4(body->x[c[2]]) - a;
        const double4 f1 = rest[0] * e1, f2 = rest[1] * e1 + rest[2] * e2;
        const double4 normal = dcross(f1, f2);
        const double t = (double)membrane->thickness[e] / (double)membrane->first[e];
        sum += rest[3] * material->energy(membrane->constant, t, ddot(f1, f1) + ddot(f2, f2),
                                          ddot(normal, normal));
    }
    return sum;
}

static double bound(const Body* body) {
    return body->membrane.rubber.material->bound(&body->membrane, body->x);
}

static void stiffen(Body* body, bool project) {
    body->membrane.rubber.material->stiffen(&body->membrane, body->x, project);
}

static void product(const Body* body, const real4* restrict d, real4* restrict out) {
    const Membrane* membrane = &body->membrane;
    for (int e = 0; e < membrane->count; e++) {
        const int* c = membrane->corner[e];
        const real4 d1 = d[c[1]] - d[c[0]], d2 = d[c[2]] - d[c[0]];
        const Stiffness* s = &membrane->stiffness[e];
        const real4 g1 = d1[0] * s->k11[0] + d1[1] * s->k11[1] + d1[2] * s->k11[2] +
                         d2[0] * s->k12[0] + d2[1] * s->k12[1] + d2[2] * s->k12[2];
        const real4 g2 = d1[0] * s->k21[0] + d1[1] * s->k21[1] + d1[2] * s->k21[2] +
                         d2[0] * s->k22[0] + d2[1] * s->k22[1] + d2[2] * s->k22[2];
        out[c[0]] -= g1 + g2;
        out[c[1]] += g1;
        out[c[2]] += g2;
    }
}

static void diagonal(const Body* body, Block* block) {
    const Membrane* membrane = &body->membrane;
    for (int e = 0; e < membrane->count; e++) {
        const int* corner = membrane->corner[e];
        const Stiffness* s = &membrane->stiffness[e];
        for (int c = 0; c < 3; c++) {
            block[corner[0]].column[c] += s->k11[c] + s->k12[c] + s->k21[c] + s->k22[c];
            block[corner[1]].column[c] += s->k11[c];
            block[corner[2]].column[c] += s->k22[c];
        }
    }
}

const Force force_membrane = {
    .name = "membrane",
    .about = "thin elements of rubber with thickness, h0 A0 W(tr C, det C)",
    .present = present,
    .add = add,
    .energy = energy,
    .bound = bound,
    .stiffen = stiffen,
    .product = product,
    .diagonal = diagonal,
    .internal = true,
};
