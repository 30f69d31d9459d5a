/// The mesh doctor: describes a mesh, mends what it can, and decides whether a balloon can be made.
///
/// Mended and reported: seams (rims at the same positions are sewn), flipped faces (oriented like
/// their neighbors, and outward if the skin is closed), unused points (left out).
/// Unusable: no faces, degenerate faces (two corners at one position, or no area), duplicate faces,
/// edges of more than two faces, sheets that touch only in a point, a surface with one side.
///
/// Sentences count faces and vertices from 1 in the order of the file, as OBJ does.
#ifndef BALLOON_MESH_DOCTOR_H
#define BALLOON_MESH_DOCTOR_H

#include <stdio.h>

#include "mesh/mesh.h"
#include "mesh/source.h"

enum { VALENCE_MAX = 16 }; ///< the histogram's last bin counts this valence and all above

typedef struct MeshReport {
    int points; ///< points of the mesh, welded and used
    int quads;
    int triangles;
    int valence[VALENCE_MAX + 1]; ///< how many points have this many edges
    int components;               ///< connected by edges
    int genus;     ///< holes through all components together, rims counted as closed; 0 if unusable
    int rims;      ///< closed loops of edges with one face
    int rim_edges; ///< edges with one face
    int nonmanifold_edges;  ///< edges of three faces or more
    int nonmanifold_points; ///< points where two sheets touch without a common edge
    int duplicate_faces;    ///< faces with the corners of an earlier one
    int degenerate_faces;
    int flipped_faces; ///< mended
    int welded_points; ///< mended
    int unused_points; ///< left out
    double area;       ///< [unit^2], 0 if unusable
    double volume;     ///< [unit^3], 0 when open or unusable
    Fault unusable;    ///< the first reason why no balloon can be made; empty text: usable
} MeshReport;

/// Examine and mend the source, number its points by first use, and make the mesh if it is usable.
/// False, and the reason in report->unusable, if not; then the mesh is empty.
bool doctor_treat(MeshSource* source, Mesh* mesh, MeshReport* report);

/// One line per finding, "label: value"; nothing when no mesh could be read.
void doctor_print(const MeshReport* report, FILE* out);

#endif
