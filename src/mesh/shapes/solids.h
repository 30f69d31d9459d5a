/// Solid shapes: cube, box, spheres, torus, capsule.
#ifndef BALLOON_MESH_SHAPES_SOLIDS_H
#define BALLOON_MESH_SHAPES_SOLIDS_H

#include "mesh/source.h"

/// Functions of shape_table's rows: they fill all of the source except its name.
void solid_cube(MeshSource* source, int n, int unused);
void solid_box(MeshSource* source, int n, int unused);
void solid_cube_sphere(MeshSource* source, int n, int unused);
void solid_icosphere(MeshSource* source, int level, int unused);
void solid_torus(MeshSource* source, int around, int across);
void solid_capsule(MeshSource* source, int around, int along);

#endif
