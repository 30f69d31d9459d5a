/// Shapes that are round or square from the start.
#ifndef BALLOON_MESH_SOLIDS_H
#define BALLOON_MESH_SOLIDS_H

#include "mesh/source.h"

/// The row's function fills all of the source but its name.
void solid_cube(MeshSource* source, int n, int unused);
void solid_cube_sphere(MeshSource* source, int n, int unused);
void solid_icosphere(MeshSource* source, int level, int unused);
void solid_torus(MeshSource* source, int around, int across);

#endif
