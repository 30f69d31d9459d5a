#include "force/material.h"

#include "base/cpu.h"
#include "base/table.h"

const Material* const material_table[] = {
    &material_neo_hookean,
    &material_mooney_rivlin,
    &material_stvk,
    &material_stvk_3d,
};
const int material_count = sizeof material_table / sizeof *material_table;

const Material* material_find(const char* name) {
    return table_find(material_table, material_count, name);
}

const Parameter* material_parameter(const Material* material, const char* name) {
    return table_row_of(material->parameters, material->parameter_count,
                        sizeof *material->parameters, name);
}

double rubber_parameter(const Rubber* rubber, const char* name, double otherwise) {
    const Parameter* parameter = material_parameter(rubber->material, name);
    return parameter ? rubber->parameter[parameter - rubber->material->parameters] : otherwise;
}

const ElementLoops* material_loops(const Material* material) {
    return material->v3 && cpu_is_v3() ? material->v3 : &material->loops;
}

void material_add(Body* body, const double* thickness, const Rubber* rubber) {
    body_add_membrane(body, thickness, rubber);
    rubber->material->constants(rubber, body->membrane.constant);
}
