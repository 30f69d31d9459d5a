#include "mesh/shape.h"

#include <string.h>

#include "mesh/shapes/sheets.h"
#include "mesh/shapes/solids.h"

// clang-format off
const Shape shape_table[] = {
    {"cube", "cube of side 2, N x N quads a side", 1, {1}, {1}, {400}, solid_cube},
    {"box", "box of side 1, N x N quads a side", 1, {1}, {1}, {400}, solid_box},
    {"cube-sphere", "sphere of radius 1 from a cube of N x N quads a side", 1, {12}, {1}, {400}, solid_cube_sphere},
    {"icosphere", "sphere of radius 1 from an icosahedron split N times, triangles", 1, {3}, {0}, {7}, solid_icosphere},
    {"torus", "ring of radii 1 and 0.4, A quads around it and B around its tube", 2, {24, 12}, {3, 3}, {1000, 1000}, solid_torus},
    {"capsule", "capsule of radius 1 and length 4 along y, A quads around and B along its straight part", 2, {16, 2}, {3, 1}, {1000, 1000}, solid_capsule},
    {"grid", "open sheet of A x B squares, 2 wide", 2, {10, 10}, {1, 1}, {1000, 1000}, sheet_grid},
    {"pillow", "two square sheets of N x N quads, 2 wide, sewn at the rim", 1, {16}, {2}, {700}, sheet_pillow},
    {"disc", "open disc of radius 1, A rings of B sectors, triangles in the middle", 2, {12, 36}, {1, 3}, {1000, 1000}, sheet_disc},
    {"discs", "two discs sewn at the rim, a foil balloon", 2, {12, 36}, {1, 3}, {700, 1000}, sheet_discs},
};
// clang-format on
const int shape_count = sizeof shape_table / sizeof *shape_table;

const Shape* shape_find(const char* name) {
    const size_t length = strcspn(name, ":");
    for (int i = 0; i < shape_count; i++)
        if (strlen(shape_table[i].name) == length &&
            strncmp(name, shape_table[i].name, length) == 0)
            return &shape_table[i];
    return NULL;
}

/// "12" or "24x12", and nothing else; false if it is not so many numbers within their ranges.
static bool read_numbers(const Shape* shape, const char* text, int number[2]) {
    for (int i = 0; i < shape->numbers; i++) {
        char* stop;
        const long value = strtol(text, &stop, 10);
        const bool last = i + 1 == shape->numbers;
        const bool digit = *text >= '0' && *text <= '9';
        if (!digit || *stop != (last ? '\0' : 'x'))
            return false;
        if (value < shape->min[i] || value > shape->max[i])
            return false;
        number[i] = (int)value;
        text = stop + 1;
    }
    return true;
}

bool shape_make(const char* name, MeshSource* source, Fault* fault) {
    const Shape* shape = shape_find(name);
    ASSERT(shape, "shape_find says whether a name is a shape");
    int number[2] = {shape->usual[0], shape->usual[1]};
    const char* colon = strchr(name, ':');
    if (colon && !read_numbers(shape, colon + 1, number)) {
        if (shape->numbers == 1)
            return fault_set(fault, name, "write %s:N, with N from %d to %d, as in %s:%d",
                             shape->name, shape->min[0], shape->max[0], shape->name,
                             shape->usual[0]);
        return fault_set(fault, name,
                         "write %s:AxB, with A from %d to %d and B from %d to %d, as in %s:%dx%d",
                         shape->name, shape->min[0], shape->max[0], shape->min[1], shape->max[1],
                         shape->name, shape->usual[0], shape->usual[1]);
    }
    shape->make(source, number[0], number[1]);
    source->name = name;
    return true;
}
