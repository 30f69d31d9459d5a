/// Validates a mesh: flaws that cannot be mended. Each function counts one kind of flaw in the
/// report, and writes the first into report->unusable, unless another flaw is there already.
#ifndef BALLOON_MESH_VALIDATE_H
#define BALLOON_MESH_VALIDATE_H

#include "mesh/doctor.h"
#include "mesh/edges.h"

/// Faces with two corners at one position, or without area.
void validate_degenerate(const MeshSource* source, MeshReport* report);

/// Faces with the same set of corners as an earlier face.
void validate_duplicate(const MeshSource* source, MeshReport* report);

/// Non-manifold edges: of three faces or more.
void validate_edges(const MeshSource* source, const Edges* edges, MeshReport* report);

/// Non-manifold points: the faces around it are not one fan joined by edges.
void validate_points(const MeshSource* source, const Edges* edges, MeshReport* report);

/// A surface with one side: two faces that no flipping orients alike (Orientation.clash).
void validate_one_sided(const MeshSource* source, const int clash[2], MeshReport* report);

#endif
