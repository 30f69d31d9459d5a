/// A mesh as a file or a shape gives it: raw arrays, not yet validated by the doctor.
#ifndef BALLOON_MESH_SOURCE_H
#define BALLOON_MESH_SOURCE_H

#include <stdbool.h>

#include "base/fault.h"
#include "base/vec.h"

enum {
    FILE_BYTES_MAX = 1 << 28, ///< [bytes] of a mesh's file: 256 MiB
    POINTS_MAX = 1 << 24,     ///< 512 MiB of positions
    FACES_MAX = 1 << 22       ///< assimp keeps some hundred bytes for each
};

typedef struct MeshSource {
    const char* name; ///< the file's path or the shape's name, for sentences; not owned
    int point_count;
    int face_count;
    double4* point;   ///< [point_count]
    int (*face)[4];   ///< [face_count] corners, a triangle's fourth is NONE
    long* point_line; ///< [point_count] line in the file, or NULL
    long* face_line;  ///< [face_count] line in the file, or NULL
} MeshSource;

/// Allocate arrays of so many points and faces, without lines.
void source_make(MeshSource* source, const char* name, int point_count, int face_count);

/// The same for a file; false with a sentence when it has more than POINTS_MAX or FACES_MAX.
bool source_make_bounded(MeshSource* source, const char* path, long points, long faces,
                         Fault* fault);

void source_free(MeshSource* source);

#endif
