/// Mesh files that assimp reads: STL (text and binary), OFF, glTF and GLB.
///
/// assimp 5.2.5 gives positions in single precision, which is what binary STL and glTF hold;
/// numbers of the text formats are rounded to it. Corners that share a vertex by index in the file
/// (OFF, glTF) share it here. STL has no indices, and glTF repeats vertices along texture seams:
/// there every face or patch has points of its own, which the doctor sews together (mesh/weld.h).
/// Transforms of the file's scene graph are applied, in double. No post-processing of assimp is
/// used: its JoinIdenticalVertices merges distinct vertices that are closer than about 1e-5.
///
/// Not among them, after a trial with damaged files: PLY, on which assimp loops forever where the
/// header is cut off, and COLLADA, which ended 4 of 1,500 runs by a segmentation fault. Of 8,000
/// files of each format above one failed, by a length in a GLB header that made assimp allocate
/// 2 GB; such headers are refused before. assimp runs in a child process of bounded time and memory
/// (mesh/bounded.h): glTF nodes nested 20,000 deep exhaust its stack, nodes that their parents list
/// twice in 24 levels take 10 GB, and it leaks 2.4 kB for each STL file that it refuses.
#ifndef BALLOON_MESH_IMPORT_H
#define BALLOON_MESH_IMPORT_H

#include <stdbool.h>

#include "base/fault.h"
#include "mesh/source.h"

/// Read the file, in the format that its extension names. Refused, beside what assimp refuses:
/// faces of other than 3 or 4 corners, positions that are not finite. Nothing is left to free on
/// failure.
bool import_read(MeshSource* source, const char* path, Fault* fault);

#endif
