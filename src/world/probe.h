/// Reads a world's outputs (world/outputs.h), in double, by name and as a CSV.
///
/// Only what a scene models has columns: there are columns for as many balls as the scene begins
/// with. `sphere0` is the first of the present balls; the columns of a ball that was removed read
/// nan.
#ifndef BALLOON_WORLD_PROBE_H
#define BALLOON_WORLD_PROBE_H

#include <stdio.h>

#include "world/world.h"

/// Header: "t,balloon0.volume,…"; the caller ends the line.
void probe_csv_header(const World* world, FILE* out);

/// One row, %.17g each.
void probe_csv_row(const World* world, FILE* out);

/// A column's value by its name ("balloon0.volume"); false when this world has no such column. Here
/// every present ball has columns, also a thrown one, and a world with balls has "pass_throughs".
bool probe_value(const World* world, const char* column, double* value);

/// All skins at present, as one OBJ file: vertices and faces in loaded order, balloon after balloon.
void probe_obj(const World* world, FILE* out);

#endif
