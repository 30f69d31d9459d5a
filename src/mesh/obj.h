/// OBJ files: vertices and faces, read without assimp.
///
/// assimp 5.2.5 reads OBJ, but gives back less than the file says: coordinates rounded to single
/// precision, and one vertex for each face corner in place of the indices. Welding by equal
/// coordinates cannot restore the indices where two vertices stand at one location, nor where
/// rounding has moved two together. Both halves of the file would have to be read here again.
/// Loading 100,000 quads, CPU time of one core, doctor and numbering included:
///
///     as below                                                   105 ms, 230 lines, exact
///     `v` and `f` lines read here, rewritten for assimp to read  180 ms, 300 lines, exact
///     assimp alone, before any weld                              100 ms for the file itself
///
/// Understood: any line ends, tabs, a backslash that continues a `v` or `f` line, indices that
/// count backward, vertex colors and weights (left out). Refused, with file and line: what is no
/// number or not finite, corners that name no vertex, faces of other than 3 or 4 corners, points
/// and lines. Lines of all other kinds (texture coordinates, normals, groups, materials) are
/// skipped.
#ifndef BALLOON_MESH_OBJ_H
#define BALLOON_MESH_OBJ_H

#include <stdbool.h>

#include "base/fault.h"
#include "mesh/source.h"

/// Read the file: its points, its faces, and the line of each. Nothing is left to free on failure.
bool obj_read(MeshSource* source, const char* path, Fault* fault);

#endif
