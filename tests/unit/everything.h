/// A body on which every row of the force table acts.
#ifndef BALLOON_TESTS_EVERYTHING_H
#define BALLOON_TESTS_EVERYTHING_H

#include "bodies.h"
#include "force/force.h"
#include "force/inflation.h"
#include "force/strings.h"
#include "mesh/measure.h"

/// A shaken closed skin with every force of the table.
static inline void everything(const Mesh* mesh, Body* body, SpringLaw spring_law, InflationLaw law,
                              const Material* material) {
    body_of(mesh, body);
    body->gravity = 9.8;
    rubber_on(body, material, 0.3, 300, 1);
    for (int e = 0; e < body->membrane.count; e++)
        body->membrane.thickness[e] *= (real)0.9;
    body_add_springs(body, paper_springs, spring_law);
    body_add_torsion(body, 0.01);
    body_inflate(body, &(Inflation){.law = law,
                                    .amount = law == INFLATE_PRESSURE ? 20 : 1.5,
                                    .unit = 10,
                                    .ambient = 10,
                                    .temperature = 1,
                                    .adiabatic = !material->reads_thickness,
                                    .weighs = law == INFLATE_GAS,
                                    .filling = filling_table[1]});
    for (int k = 0; k < force_count; k++)
        for (int p = 0; p < force_table[k]->parameter_count; p++)
            body->force_parameter[k][p] = 1;
    body_tie(body, 3, (double[]){0.1, -3, 0.2}, 50, 0.9);
    body_tie(body, 5, (double[]){0, 4, 0}, 50, 1.2); // slack
    shake(body, 0.05);
    for (int i = 0; i < body->count; i++)
        body->v[i] = (real4){(real)0.3, (real)-0.1, (real)(0.01 * i), 0};
}

/// Such a body for each law of springs, material and law of inflation.
static inline void each_everything(void (*visit)(Body* body)) {
    Mesh mesh;
    mesh_of("cube-sphere:4", &mesh);
    for (int n = 0; n < SPRING_LAWS * material_count; n++)
        for (int law = INFLATE_AREA; law < INFLATION_LAWS; law++) {
            Body body;
            everything(&mesh, &body, (SpringLaw)(n % SPRING_LAWS), (InflationLaw)law,
                       material_table[n / SPRING_LAWS]);
            visit(&body);
            body_free(&body);
        }
    mesh_free(&mesh);
}

#endif
