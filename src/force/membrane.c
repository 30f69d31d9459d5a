/// The rubber skin: E = sum over elements of h0 A0 W(tr C, det C); see body/membrane.h and the
/// table of materials. The forces on an undeformed skin are zero; net force and torque vanish in
/// every state.
#include "base/crew.h"
#include "force/force.h"
#include "force/material.h"

static bool present(const Body* body) {
    return body->membrane.count > 0;
}

/// Arguments of the tasks. Parts of one parity run at a time, because those share no particle.
typedef struct Job {
    Body* body;
    int odd;
} Job;

static void add_part(void* self, int number) {
    const Job* job = self;
    Body* body = job->body;
    const Membrane* membrane = &body->membrane;
    const int part = 2 * number + job->odd;
    material_loops(membrane->rubber.material)
        ->add(membrane, membrane_part(membrane->eights, membrane->parts, part),
              membrane_part(membrane->eights, membrane->parts, part + 1), body->x, body->f);
}

static void add(Body* body) {
    const int parts = body->membrane.parts;
    crew_run(add_part, &(Job){body, 0}, (parts + 1) / 2);
    crew_run(add_part, &(Job){body, 1}, parts / 2);
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

/// The bound of each part.
typedef struct Bounds {
    const Body* body;
    double part[MEMBRANE_MAX_PARTS];
} Bounds;

static void bound_part(void* self, int part) {
    Bounds* bounds = self;
    const Membrane* membrane = &bounds->body->membrane;
    bounds->part[part] =
        material_loops(membrane->rubber.material)
            ->bound(membrane, membrane_part(membrane->eights, membrane->parts, part),
                    membrane_part(membrane->eights, membrane->parts, part + 1), bounds->body->x);
}

static double bound(const Body* body) {
    Bounds bounds = {.body = body};
    crew_run(bound_part, &bounds, body->membrane.parts);
    double max = 0;
    for (int part = 0; part < body->membrane.parts; part++)
        max = fmax(max, bounds.part[part]);
    return max;
}

static Stencils stencils(const Body* body) {
    return (Stencils){body->membrane.count, 3, (const int*)body->membrane.corner};
}

static void assemble(const Body* body, double factor, bool project, const int* block_at,
                     BlockMatrix* matrix) {
    const Membrane* membrane = &body->membrane;
    material_loops(membrane->rubber.material)
        ->assemble(membrane, body->x, (real)factor, project, block_at, matrix->value);
}

const Force force_membrane = {
    .name = "membrane",
    .about = "thin elements of rubber with thickness, h0 A0 W(tr C, det C)",
    .present = present,
    .add = add,
    .energy = energy,
    .bound = bound,
    .stencils = stencils,
    .assemble = assemble,
    .elastic = true,
};
