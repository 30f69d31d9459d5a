/// Parametric shapes, a table: "name" or "name:N" or "name:AxB".
///
/// Their corners share points by number, so that nothing is left to weld, and are computed with
/// + - * / and square root only, so that every machine makes the same bits.
#ifndef BALLOON_MESH_SHAPE_H
#define BALLOON_MESH_SHAPE_H

#include <stdbool.h>

#include "base/fault.h"
#include "mesh/source.h"

typedef struct Shape {
    const char* name;
    const char* about; ///< size and meaning of the numbers
    int numbers;       ///< how many numbers may follow the colon: 1 or 2
    int given[2];      ///< when none are given
    int least[2];
    int most[2];
    void (*make)(MeshSource* source, int a, int b);
} Shape;

extern const Shape shape_table[];
extern const int shape_count;

/// The row whose name stands before the colon, or NULL: then `name` is no shape but a file.
const Shape* shape_find(const char* name);

/// Make the shape that `name` says. False with a sentence when its numbers are wrong.
bool shape_make(const char* name, MeshSource* source, Fault* fault);

#endif
