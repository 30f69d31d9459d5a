/// A mesh by its name: an OBJ file through assimp, or a shape that the program makes itself.
///
/// Shared topology is restored exactly, whatever the mesh's size and place. assimp hands out one
/// vertex per face corner and rounds to single precision; so it is given a text in which each
/// vertex's coordinates are its number (mesh/obj.h): it resolves the faces, and every corner that
/// comes back names its vertex.
#ifndef BALLOON_MESH_LOAD_H
#define BALLOON_MESH_LOAD_H

#include "mesh/doctor.h"

/// Load `name`: a shape ("cube", "cube-sphere:12", …) or the path of an .obj file.
/// The report is filled even when the mesh is unusable. The caller frees the mesh.
bool mesh_load(const char* name, Mesh* mesh, MeshReport* report, Fault* fault);

#endif
