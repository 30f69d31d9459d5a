/// Flat shapes: open sheets, and pairs of sheets sewn together at their rims.
///
/// Sewn sheets bulge slightly, so that they enclose a volume and their orientation is defined:
///
///     y = +-BULGE (1 - x^2)(1 - z^2)    pillow
///     y = +-BULGE (1 - r^2)             discs
///
/// A line across is longer by about 2/3 BULGE^2 than if it were flat, less than 1e-4.
#ifndef BALLOON_MESH_SHAPES_SHEETS_H
#define BALLOON_MESH_SHAPES_SHEETS_H

#include "mesh/source.h"

static const double BULGE = 0.01; ///< [unit] half the thickness in the middle

void sheet_grid(MeshSource* source, int columns, int rows);
void sheet_pillow(MeshSource* source, int n, int unused);
void sheet_disc(MeshSource* source, int rings, int sectors);
void sheet_discs(MeshSource* source, int rings, int sectors);

#endif
