#include "mesh/shapes/solids.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/shapes/circle.h"
#include "mesh/edges.h"

/// The number of a point on the surface of the lattice 0 … n in x, y and z. Layers of z follow each
/// other: the first and the last are full squares, those between are rings of 4 n points.
///
///       3n ... 2n
///        :     :       a ring's points count around from (0, 0)
///        0 ...  n
static int lattice_number(int n, const int at[3]) {
    const int square = (n + 1) * (n + 1);
    const int i = at[0];
    const int j = at[1];
    if (at[2] == 0)
        return j * (n + 1) + i;
    if (at[2] == n)
        return square + (n - 1) * 4 * n + j * (n + 1) + i;
    const int ring = square + (at[2] - 1) * 4 * n;
    if (j == 0)
        return ring + i;
    if (i == n)
        return ring + n + j;
    if (j == n)
        return ring + 3 * n - i;
    return ring + 4 * n - j;
}

/// Corner (u, v) of the side that faces along `axis`, upward or downward. Seen along u and v the
/// upward side is counter-clockwise.
static int side_point(MeshSource* source, int n, int axis, bool up, int u, int v) {
    int at[3];
    at[axis] = up ? n : 0;
    at[(axis + 1) % 3] = u;
    at[(axis + 2) % 3] = v;
    const int number = lattice_number(n, at);
    for (int k = 0; k < 3; k++)
        source->point[number][k] = (double)(2 * at[k] - n) / n;
    return number;
}

void solid_cube(MeshSource* source, int n, int unused) {
    (void)unused;
    source_make(source, NULL, 6 * n * n + 2, 6 * n * n);
    int f = 0;
    for (int side = 0; side < 6; side++) {
        const int axis = side / 2;
        const bool up = side % 2;
        for (int v = 0; v < n; v++) {
            for (int u = 0; u < n; u++) {
                int* corner = source->face[f++];
                corner[0] = side_point(source, n, axis, up, u, v);
                corner[up ? 1 : 3] = side_point(source, n, axis, up, u + 1, v);
                corner[2] = side_point(source, n, axis, up, u + 1, v + 1);
                corner[up ? 3 : 1] = side_point(source, n, axis, up, u, v + 1);
            }
        }
    }
}

void solid_box(MeshSource* source, int n, int unused) {
    solid_cube(source, n, unused);
    for (int i = 0; i < source->point_count; i++)
        source->point[i] *= 0.5;
}

static void project_to_sphere(MeshSource* source) {
    for (int i = 0; i < source->point_count; i++)
        source->point[i] /= dlength(source->point[i]);
}

void solid_cube_sphere(MeshSource* source, int n, int unused) {
    solid_cube(source, n, unused);
    project_to_sphere(source);
}

static void make_icosahedron(MeshSource* source) {
    // clang-format off
    static const int corner[20][3] = {
        {0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
        {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
        {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
        {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1},
    };
    // clang-format on
    source_make(source, NULL, 12, 20);
    for (int f = 0; f < 20; f++) {
        memcpy(source->face[f], corner[f], sizeof corner[f]);
        source->face[f][3] = NONE;
    }

    // three golden rectangles, each upright in the plane of two axes
    const double golden = (1 + sqrt(5)) / 2;
    for (int i = 0; i < 12; i++) {
        const int axis = i / 4;
        source->point[i][axis] = i % 2 ? 1 : -1;
        source->point[i][(axis + 1) % 3] = i % 4 < 2 ? golden : -golden;
    }
    project_to_sphere(source);
}

/// Each triangle becomes four; the new points are the middles of the edges, one each.
///
///          c
///        /   \          .
///      ca --- bc
///     /  \   /  \       .
///    a --- ab --- b
static void split_triangles(MeshSource* source) {
    Edges edges;
    edges_find(&edges, (const int(*)[4])source->face, source->face_count, source->point_count);
    MeshSource finer;
    source_make(&finer, NULL, source->point_count + edges.count, 4 * source->face_count);

    memcpy(finer.point, source->point, (size_t)source->point_count * sizeof *finer.point);
    for (int e = 0; e < edges.count; e++)
        finer.point[source->point_count + e] =
            source->point[edges.end[e][0]] + source->point[edges.end[e][1]];

    for (int f = 0; f < source->face_count; f++) {
        const int* corner = source->face[f];
        const int* edge = &edges.of_side[4 * f];
        const int a = corner[0];
        const int b = corner[1];
        const int c = corner[2];
        const int ab = source->point_count + edge[0];
        const int bc = source->point_count + edge[1];
        const int ca = source->point_count + edge[2];
        const int part[4][4] = {
            {a, ab, ca, NONE}, {b, bc, ab, NONE}, {c, ca, bc, NONE}, {ab, bc, ca, NONE}};
        memcpy(finer.face[4 * f], part, sizeof part);
    }
    edges_free(&edges);
    source_free(source);
    *source = finer;
    project_to_sphere(source);
}

void solid_icosphere(MeshSource* source, int level, int unused) {
    (void)unused;
    make_icosahedron(source);
    for (int i = 0; i < level; i++)
        split_triangles(source);
}

static const double TUBE = 0.4; ///< radius of the torus' tube, its ring's being 1

void solid_torus(MeshSource* source, int around, int across) {
    source_make(source, NULL, around * across, around * across);
    for (int i = 0; i < around; i++) {
        const CirclePoint ring = circle_point(i, around);
        for (int j = 0; j < across; j++) {
            const CirclePoint tube = circle_point(j, across);
            const double radius = 1 + TUBE * tube.cosine;
            const int number = i * across + j;
            source->point[number] =
                (double4){radius * ring.cosine, TUBE * tube.sine, -radius * ring.sine};

            const int next_i = (i + 1) % around * across;
            const int next_j = (j + 1) % across;
            int* corner = source->face[number];
            corner[0] = number;
            corner[1] = next_i + j;
            corner[2] = next_i + next_j;
            corner[3] = i * across + next_j;
        }
    }
}
