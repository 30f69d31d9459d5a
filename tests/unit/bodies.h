/// Bodies for tests: made from a shape or a model, or of a few particles.
#ifndef BALLOON_TESTS_BODIES_H
#define BALLOON_TESTS_BODIES_H

#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "body/body.h"
#include "force/material.h"
#include "law.h"
#include "mesh/load.h"
#include "solve/method.h"

/// The springs of the mass-spring paper's authors [N/m], and their particle's mass [kg].
static const double paper_springs[SPRING_KINDS] = {50, 10, 10};
static const double paper_mass = 1e-3;

static inline void mesh_of(const char* name, Mesh* mesh) {
    MeshReport report = {0};
    Fault fault = {0};
    if (!mesh_load(name, mesh, &report, &fault)) {
        fault_print(&fault, stderr);
        fail();
    }
}

/// A body at rest at the mesh's points; each particle has the paper's mass; no forces.
static inline void body_of(const Mesh* mesh, Body* body) {
    body_make(body, mesh, &(Placement){.scale = 1}, paper_mass);
}

/// A skin of rubber of one thickness, Poisson's ratio 0.4 where the law has one.
static inline void rubber_on(Body* body, const Material* material, double thickness, double young,
                             double density) {
    double* h = new_array(double, body->count);
    for (int i = 0; i < body->count; i++)
        h[i] = thickness;
    Rubber rubber = {.material = material, .young = young, .density = density};
    for (int k = 0; k < material->parameter_count; k++)
        rubber.parameter[k] = strcmp(material->parameters[k].name, "poisson") == 0 ? 0.4 : 0.2;
    material_add(body, h, &rubber);
    free(h);
}

/// Steps of a method, each a kick and a drift, of a system of one body that nothing touches.
static inline void steps_of(const Method* method, Body* body, const Solver* solver, double h,
                            int count) {
    System system;
    Contacts contacts = {.law = CONTACT_IMPULSE};
    SolveStats stats;
    system_open(&system, 1);
    system.body[0] = body;
    system.workspace[0] = method->open ? method->open(body, solver) : NULL;
    system.stats[0] = &stats;
    system.v_start[0] = new_array(real4, body->count);
    for (int n = 0; n < count; n++) {
        double drift = h;
        assert_true(method->kick(method, &system, &contacts, h, &drift));
        method->drift(body, drift);
    }
    free(system.v_start[0]);
    if (method->close)
        method->close(system.workspace[0]);
    system_close(&system);
}

/// Every particle moved by up to `by` in each direction, the same every time.
static inline void shake(Body* body, double by) {
    Random random = {12345};
    for (int i = 0; i < body->count; i++)
        for (int k = 0; k < 3; k++)
            body->x[i][k] += (real)(by * (2 * random_next(&random) - 1));
}

/// Particles on a line along x at the given positions, joined to a chain of equal Hooke springs
/// whose rest lengths are the distances. There is no mesh, so only forces without one may act.
static inline void chain_of(Body* body, const double* position, int count, double mass,
                            double stiffness) {
    *body = (Body){.count = count,
                   .x = new_array(real4, count),
                   .v = new_array(real4, count),
                   .f = new_array(real4, count),
                   .mass = new_array(real, count),
                   .inverse_mass = new_array(real, count),
                   .size = 1};
    Springs* springs = &body->springs;
    *springs = (Springs){.count = count - 1,
                         .from = {0, count - 1, count - 1, count - 1},
                         .end = new_array(int[2], count - 1),
                         .stiffness = new_array(real, count - 1),
                         .rest = new_array(real, count - 1),
                         .active = new_array(real, count - 1),
                         .bound = 4 * stiffness / mass};
    for (int i = 0; i < count; i++) {
        body->x[i] = (real4){(real)position[i], 0, 0, 0};
        body->mass[i] = (real)mass;
        body->inverse_mass[i] = (real)(1 / mass);
    }
    for (int s = 0; s < count - 1; s++) {
        springs->end[s][0] = s;
        springs->end[s][1] = s + 1;
        springs->stiffness[s] = springs->active[s] = (real)stiffness;
        springs->rest[s] = (real)(position[s + 1] - position[s]);
    }
    body_slice(body);
}

#endif
