#include "contact/ball_triangle.h"

/// Weights of the point of triangle (a, b, c) nearest p.
/// Source: C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
static void nearest(real4 p, real4 a, real4 b, real4 c, real weight[3]) {
    const real4 ab = b - a, ac = c - a, ap = p - a;
    const real d1 = dot(ab, ap), d2 = dot(ac, ap);
    weight[0] = 1, weight[1] = 0, weight[2] = 0;
    if (d1 <= 0 && d2 <= 0)
        return;

    const real4 bp = p - b;
    const real d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) {
        weight[0] = 0, weight[1] = 1;
        return;
    }
    const real vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        weight[1] = d1 / (d1 - d3);
        weight[0] = 1 - weight[1];
        return;
    }

    const real4 cp = p - c;
    const real d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) {
        weight[0] = 0, weight[2] = 1;
        return;
    }
    const real vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        weight[2] = d2 / (d2 - d6);
        weight[0] = 1 - weight[2];
        return;
    }
    const real va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        weight[2] = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        weight[1] = 1 - weight[2];
        weight[0] = 0;
        return;
    }
    weight[1] = vb / (va + vb + vc);
    weight[2] = vc / (va + vb + vc);
    weight[0] = 1 - weight[1] - weight[2];
}

void ball_triangle_contact(Contact* contact, Sphere* sphere, Body* body, int triangle, real side) {
    const int* corner = body->mesh->triangle[triangle];
    const real4 a = body->x[corner[0]], b = body->x[corner[1]], c = body->x[corner[2]];
    real weight[3];
    nearest(sphere->x, a, b, c, weight);

    const real4 p = weight[0] * a + weight[1] * b + weight[2] * c;
    const real4 away = sphere->x - p;
    const real distance = length(away);
    real4 normal = away / distance;
    if (!(distance > (real)1e-6 * sphere->radius)) {
        const real4 across = cross(b - a, c - a);
        const real area = length(across);
        normal = area > 0 ? side / area * across : (real4){0, side, 0, 0};
    }

    *contact = (Contact){.node_count = 4,
                         .lever_count = 1,
                         .normal = normal,
                         .gap = distance - sphere->radius,
                         .size = sphere->radius,
                         .friction = sphere->friction,
                         .restitution = sphere->restitution,
                         .feature = triangle};
    contact->node[0] = (ContactNode){&sphere->v, &sphere->x, 1, 1 / sphere->mass, sphere->mass};
    for (int k = 0; k < 3; k++) {
        const int i = corner[k];
        const bool held = body->inverse_mass[i] <= 0;
        contact->node[k + 1] =
            (ContactNode){&body->v[i], &body->x[i], -weight[k], -weight[k] * body->inverse_mass[i],
                          held ? (real)INFINITY : body->mass[i]};
    }
    contact->lever[0] =
        (ContactLever){-distance * normal, &sphere->spin, 1 / sphere_inertia(sphere)};
}
