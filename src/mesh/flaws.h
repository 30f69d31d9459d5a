/// What no mending can make a balloon of. Each finds and counts one flaw in the report, and names
/// the first in report->unusable, unless another flaw stands there already.
#ifndef BALLOON_MESH_FLAWS_H
#define BALLOON_MESH_FLAWS_H

#include "mesh/doctor.h"
#include "mesh/edges.h"

/// Two corners in one place, or no area.
void flaw_degenerate(const MeshSource* source, MeshReport* report);

/// The same set of corners as an earlier face.
void flaw_duplicate(const MeshSource* source, MeshReport* report);

/// An edge of three faces or more.
void flaw_edges(const MeshSource* source, const Edges* edges, MeshReport* report);

/// A point whose faces do not hang together around it.
void flaw_points(const MeshSource* source, const Edges* edges, MeshReport* report);

/// Two faces that no turning over brings into line.
void flaw_one_sided(const MeshSource* source, const int clash[2], MeshReport* report);

#endif
