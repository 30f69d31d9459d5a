/// Writes a skin as OBJ: vertices and faces in loaded order, each number exact (%.17g).
#ifndef BALLOON_MESH_WRITE_H
#define BALLOON_MESH_WRITE_H

#include "mesh/mesh.h"

/// x: [point_count]. `first` is added to each vertex number, for several skins in one file.
void write_obj(const Mesh* mesh, const real4* x, int first, FILE* out);

#endif
