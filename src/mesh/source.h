/// A mesh as a file or a shape gives it: raw arrays, before the doctor has seen them.
#ifndef BALLOON_MESH_SOURCE_H
#define BALLOON_MESH_SOURCE_H

#include "base/vec.h"

typedef struct MeshSource {
    const char* name; ///< the file's path or the shape's name, for sentences; not owned
    int point_count;
    int face_count;
    double4* point;   ///< [point_count]
    int (*face)[4];   ///< [face_count] corners, a triangle's fourth is NONE
    long* point_line; ///< [point_count] line in the file, or NULL
    long* face_line;  ///< [face_count] line in the file, or NULL
} MeshSource;

/// Room for so many points and faces, without lines.
void source_make(MeshSource* source, const char* name, int point_count, int face_count);

void source_free(MeshSource* source);

#endif
