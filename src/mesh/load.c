#include "mesh/load.h"

#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "base/table.h"
#include "mesh/import.h"
#include "mesh/obj.h"
#include "mesh/shape.h"

const MeshFormat mesh_format_table[] = {
    {".obj", obj_read},    {".stl", import_read},  {".off", import_read},
    {".glb", import_read}, {".gltf", import_read},
};
const int mesh_format_count = sizeof mesh_format_table / sizeof *mesh_format_table;

const MeshFormat* mesh_format_of(const char* name) {
    const char* dot = strrchr(name, '.');
    for (int k = 0; dot && k < mesh_format_count; k++)
        if (strcasecmp(dot, mesh_format_table[k].extension) == 0)
            return &mesh_format_table[k];
    return NULL;
}

/// The fault for a name that is neither a shape nor a file of a known format.
static bool refuse_name(const char* name, Fault* fault) {
    char names[256];
    if (access(name, F_OK) == 0)
        return fault_set(fault, name,
                         "is not a mesh file (%s); convert it with Blender or a similar program",
                         table_names_of(mesh_format_table, mesh_format_count,
                                        sizeof *mesh_format_table, names, sizeof names));
    return fault_set(
        fault, name, "there is no such file and no such shape; there are %s",
        table_names_of(shape_table, shape_count, sizeof *shape_table, names, sizeof names));
}

static bool read_source(const char* name, MeshSource* source, Fault* fault) {
    if (shape_find(name))
        return shape_make(name, source, fault);
    const MeshFormat* format = mesh_format_of(name);
    return format ? format->read(source, name, fault) : refuse_name(name, fault);
}

bool mesh_load(const char* name, Mesh* mesh, MeshReport* report, Fault* fault) {
    *mesh = (Mesh){0};
    *report = (MeshReport){0};
    MeshSource source;
    if (!read_source(name, &source, fault))
        return false;
    const bool usable = doctor_treat(&source, mesh, report);
    source_free(&source);
    if (!usable)
        *fault = report->unusable;
    return usable;
}
