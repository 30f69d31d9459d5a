/// Parametric shapes, a table: "name" or "name:N" or "name:AxB".
///
/// Faces share points by index, so that there is nothing to weld. Points are computed with + - * /
/// and square root only, so that every machine computes the same bits.
#ifndef BALLOON_MESH_SHAPE_H
#define BALLOON_MESH_SHAPE_H

#include <stdbool.h>

#include "base/fault.h"
#include "mesh/source.h"

typedef struct Shape {
    const char* name;
    const char* about; ///< size, and meaning of the numbers
    int numbers;       ///< how many numbers may follow the colon: 1 or 2
    int usual[2];      ///< default numbers
    int min[2];
    int max[2];
    void (*make)(MeshSource* source, int a, int b);
} Shape;

extern const Shape shape_table[];
extern const int shape_count;

/// The row whose name stands before the colon, or NULL: then `name` is not a shape.
const Shape* shape_find(const char* name);

/// Make the shape of this name. False with a sentence when its numbers are out of range.
bool shape_make(const char* name, MeshSource* source, Fault* fault);

#endif
