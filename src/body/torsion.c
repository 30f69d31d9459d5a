#include "body/torsion.h"

#include <stdlib.h>

#include "base/memory.h"

static bool share_a_face(const Mesh* mesh, int p, int q) {
    for (int k = mesh->point_face_from[p]; k < mesh->point_face_from[p + 1]; k++) {
        const int* face = mesh->face[mesh->point_face[k]];
        for (int c = 0; c < face_corners(face); c++)
            if (face[c] == q)
                return true;
    }
    return false;
}

/// Visit every path p - m - q once; count them, and store them where `path` is given.
static int walk(const Mesh* mesh, int (*path)[3]) {
    int count = 0;
    for (int m = 0; m < mesh->point_count; m++) {
        const int end = mesh->point_edge_from[m + 1];
        for (int i = mesh->point_edge_from[m]; i < end; i++) {
            for (int j = i + 1; j < end; j++) {
                const int p = mesh_across(mesh, mesh->point_edge[i], m);
                const int q = mesh_across(mesh, mesh->point_edge[j], m);
                if (share_a_face(mesh, p, q))
                    continue;
                if (path) {
                    path[count][0] = p;
                    path[count][1] = m;
                    path[count][2] = q;
                }
                count++;
            }
        }
    }
    return count;
}

void torsion_find(const Mesh* mesh, Torsion* torsion) {
    torsion->count = walk(mesh, NULL);
    torsion->path = new_array(int[3], torsion->count);
    walk(mesh, torsion->path);
}

void torsion_free(Torsion* torsion) {
    free(torsion->path);
    free(torsion->rest);
    *torsion = (Torsion){0};
}
