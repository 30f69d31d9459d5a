#include "mesh/shapes/sheets.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/shapes/circle.h"
#include "mesh/mesh.h"

static void set_face(MeshSource* source, int f, int a, int b, int c, int d) {
    int* corner = source->face[f];
    corner[0] = a;
    corner[1] = b;
    corner[2] = c;
    corner[3] = d;
}

/// Seen from above, x to the right and z towards us, (i, j) -> (i, j + 1) -> (i + 1, j + 1) is
/// counter-clockwise: the sheet faces upward.
void sheet_grid(MeshSource* source, int columns, int rows) {
    source_make(source, NULL, (columns + 1) * (rows + 1), columns * rows);
    for (int j = 0; j <= rows; j++)
        for (int i = 0; i <= columns; i++)
            source->point[j * (columns + 1) + i] =
                (double4){(double)(2 * i - columns) / columns, 0, (double)(2 * j - rows) / columns};

    for (int j = 0; j < rows; j++) {
        for (int i = 0; i < columns; i++) {
            const int a = j * (columns + 1) + i;
            const int d = a + columns + 1;
            set_face(source, j * columns + i, a, d, d + 1, a + 1);
        }
    }
}

/// Rings of equal width around point 0, each divided into sectors; the first ring consists of triangles.
void sheet_disc(MeshSource* source, int rings, int sectors) {
    source_make(source, NULL, 1 + rings * sectors, rings * sectors);
    for (int r = 0; r < rings; r++) {
        for (int s = 0; s < sectors; s++) {
            const CirclePoint at = circle_point(s, sectors);
            const double radius = (double)(r + 1) / rings;
            const int outer = 1 + r * sectors + s;
            const int outer_next = 1 + r * sectors + (s + 1) % sectors;
            source->point[outer] = (double4){radius * at.cosine, 0, -radius * at.sine};
            if (r == 0)
                set_face(source, s, 0, outer, outer_next, NONE);
            else
                set_face(source, r * sectors + s, outer - sectors, outer, outer_next,
                         outer_next - sectors);
        }
    }
}

/// Sew the sheet to its mirror image below. Points at height zero are the rim and serve both.
static void sew_to_mirror_image(MeshSource* sheet) {
    const int points = sheet->point_count;
    const int faces = sheet->face_count;
    MeshSource both;
    source_make(&both, NULL, 2 * points, 2 * faces);

    int* below = new_array(int, points);
    both.point_count = points;
    for (int i = 0; i < points; i++) {
        both.point[i] = sheet->point[i];
        below[i] = sheet->point[i][1] == 0 ? i : both.point_count++;
        both.point[below[i]] = sheet->point[i] * (double4){1, -1, 1, 0};
    }
    for (int f = 0; f < faces; f++) {
        const int* c = sheet->face[f];
        set_face(&both, f, c[0], c[1], c[2], c[3]);
        if (c[3] == NONE)
            set_face(&both, faces + f, below[c[0]], below[c[2]], below[c[1]], NONE);
        else
            set_face(&both, faces + f, below[c[0]], below[c[3]], below[c[2]], below[c[1]]);
    }
    free(below);
    source_free(sheet);
    *sheet = both;
}

void sheet_pillow(MeshSource* source, int n, int unused) {
    (void)unused;
    sheet_grid(source, n, n);
    for (int i = 0; i < source->point_count; i++) {
        double4* p = &source->point[i];
        (*p)[1] = BULGE * (1 - (*p)[0] * (*p)[0]) * (1 - (*p)[2] * (*p)[2]);
    }
    sew_to_mirror_image(source);
}

void sheet_discs(MeshSource* source, int rings, int sectors) {
    sheet_disc(source, rings, sectors);
    for (int i = 0; i < source->point_count; i++) {
        // the height follows from the ring's number, so that it is exactly zero at the rim
        const int ring = i == 0 ? 0 : (i - 1) / sectors + 1;
        const double radius = (double)ring / rings;
        source->point[i][1] = BULGE * (1 - radius * radius);
    }
    sew_to_mirror_image(source);
}
