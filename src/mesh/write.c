#include "mesh/write.h"

void write_obj(const Mesh* mesh, const real4* x, int first, FILE* out) {
    for (int k = 0; k < mesh->point_count; k++) {
        const double4 p = to_double4(x[mesh->inside[k]]);
        fprintf(out, "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    }
    for (int f = 0; f < mesh->face_count; f++) {
        const int* corner = mesh->face[f];
        fprintf(out, "f");
        for (int k = 0; k < face_corners(corner); k++)
            fprintf(out, " %d", first + mesh->loaded[corner[k]] + 1); // OBJ counts from 1
        fprintf(out, "\n");
    }
}
