#include "contact/shared_feature.h"

#include <stdlib.h>

#include "base/memory.h"

static bool has(const int triangle[3], int point) {
    return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

/// Triangles around each point, in rising order: from[i] … from[i + 1] - 1 of around.
static int* triangles_around(const Mesh* mesh, int* from) {
    for (int t = 0; t < mesh->triangle_count; t++)
        for (int k = 0; k < 3; k++)
            from[mesh->triangle[t][k] + 1]++;
    for (int i = 0; i < mesh->point_count; i++)
        from[i + 1] += from[i];
    int* around = new_array(int, from[mesh->point_count]);
    int* next = new_array(int, mesh->point_count);
    for (int t = 0; t < mesh->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const int i = mesh->triangle[t][k];
            around[from[i] + next[i]++] = t;
        }
    free(next);
    return around;
}

unsigned char* shared_feature_owners(const Mesh* mesh) {
    unsigned char* owners = new_array(unsigned char, mesh->triangle_count);
    int* from = new_array(int, mesh->point_count + 1);
    int* around = triangles_around(mesh, from);
    for (int t = 0; t < mesh->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const int a = mesh->triangle[t][k], b = mesh->triangle[t][(k + 1) % 3];
            if (around[from[a]] == t)
                owners[t] |= (unsigned char)(1 << k);
            int first = from[a];
            while (!has(mesh->triangle[around[first]], b))
                first++;
            if (around[first] == t)
                owners[t] |= (unsigned char)(8 << k);
        }
    free(from);
    free(around);
    return owners;
}

bool shared_feature_owned(const Contact* contact, const unsigned char* owners) {
    const real* w = contact->weight + 1; // of the corners: less than 0, or 0
    const int own = owners[contact->triangle];
    for (int k = 0; k < 3; k++) {
        const bool here = w[k] < 0, next = w[(k + 1) % 3] < 0, last = w[(k + 2) % 3] < 0;
        if (here && !next && !last)
            return own >> k & 1;
        if (here && next && !last)
            return own >> (3 + k) & 1;
    }
    return true;
}
