/// The text of an OBJ file, checked line by line and reduced to what a skin is made of.
///
/// Vertices are read here, in double and whatever the locale. What is left for assimp is a text of
/// plain `v` and `f` lines in which each vertex has its own number for coordinates:
///
///     v 0.348799 -0.334989 -0.0832331          v 0 0 0
///     usemtl skin                        ->    v 1 0 0
///     v 0.313132 -0.399051 0.881192            f -2 -1 1
///     f -2/7/1 -1/8/1 1/9/1   # belly
///
/// Understood: any line ends, tabs, a backslash that continues a `v` or `f` line, vertex colours
/// and weights (left out). Refused, with file and line: what is no number or not finite, faces of
/// other than 3 or 4 corners, points and lines. Texture coordinates, normals, groups, materials and
/// all other kinds of line do not matter to a skin and are not looked at.
#ifndef BALLOON_MESH_OBJ_H
#define BALLOON_MESH_OBJ_H

#include <stdbool.h>
#include <stddef.h>

#include "base/fault.h"
#include "mesh/source.h"

enum {
    FILE_BYTES_MOST = 1 << 28, ///< [bytes] 256 MiB
    FACES_MOST = 1 << 22,      ///< assimp keeps some hundred bytes for each
    POINTS_MOST = 1 << 24      ///< up to here a float can be every vertex's number
};

typedef struct ObjText {
    char* text;  ///< [size] the plain lines, ends with a zero that is not counted
    size_t size; ///< [bytes]
} ObjText;

/// Read the file into the plain text and the source: its points, its lines, room for its faces.
/// Nothing is left to free when it fails.
bool obj_read(ObjText* obj, MeshSource* source, const char* path, Fault* fault);

/// After assimp has refused the text: find the first corner that names no vertex, or return true.
bool obj_check_corners(const ObjText* obj, const MeshSource* source, Fault* fault);

void obj_free(ObjText* obj);

#endif
