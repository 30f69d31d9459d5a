/// Reads a world's outputs (world/outputs.h), in double, by name and as a CSV.
///
/// What a scene does not model has no column: balls have columns in a scene that begins with some,
/// as many as it begins with. `sphere0` is the first of the balls that there are; while there is no
/// ball of a number, because they were taken away, its columns read nan.
#ifndef BALLOON_WORLD_PROBE_H
#define BALLOON_WORLD_PROBE_H

#include <stdio.h>

#include "world/world.h"

/// Header: "t,balloon0.volume,…"; the caller ends the line.
void probe_csv_header(const World* world, FILE* out);

/// One row, %.17g each.
void probe_csv_row(const World* world, FILE* out);

/// A column's value by its name ("balloon0.volume"); false when this world has no such column. Here
/// every ball that is there has its own, thrown ones too, and where there are balls there is
/// "pass_throughs".
bool probe_value(const World* world, const char* column, double* value);

/// All skins as they are now, one OBJ: vertices and faces in loaded order, balloon after balloon.
void probe_obj(const World* world, FILE* out);

#endif
