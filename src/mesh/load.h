/// Loads a mesh by its name: a file in a format of the table, or a built-in shape.
///
/// The topology is exactly the file's: points are shared by index, never by a tolerance.
#ifndef BALLOON_MESH_LOAD_H
#define BALLOON_MESH_LOAD_H

#include "mesh/doctor.h"

typedef struct MeshFormat {
    const char* extension; ///< with its dot, in lower case
    bool (*read)(MeshSource* source, const char* path, Fault* fault);
} MeshFormat;

extern const MeshFormat mesh_format_table[];
extern const int mesh_format_count;

/// The format that the name's extension names, in any case; NULL if none does.
const MeshFormat* mesh_format_of(const char* name);

/// Load `name`: a shape ("cube", "cube-sphere:12", …) or the path of a file.
/// The report is filled even when the mesh is unusable. The caller frees the mesh.
bool mesh_load(const char* name, Mesh* mesh, MeshReport* report, Fault* fault);

#endif
