#include "contact/shared_feature.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/counting_sort.h"

static bool has(const int triangle[3], int point) {
    return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

unsigned char* shared_feature_owners(const Mesh* mesh) {
    unsigned char* owners = new_array(unsigned char, mesh->triangle_count);
    // corners sorted by their points: those of point i are from[i] … from[i + 1] - 1 of corner
    const int corners = 3 * mesh->triangle_count;
    int* from = new_array(int, mesh->point_count + 1);
    int* corner = new_array(int, corners);
    counting_sort(mesh->triangle[0], corners, mesh->point_count, from, corner);
    for (int t = 0; t < mesh->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const int a = mesh->triangle[t][k], b = mesh->triangle[t][(k + 1) % 3];
            if (corner[from[a]] / 3 == t)
                owners[t] |= (unsigned char)(1 << k);
            int first = from[a];
            while (!has(mesh->triangle[corner[first] / 3], b))
                first++;
            if (corner[first] / 3 == t)
                owners[t] |= (unsigned char)(8 << k);
        }
    free(from);
    free(corner);
    return owners;
}

bool shared_feature_owned(const Contact* contact, const unsigned char* owners) {
    const ContactNode* corner = contact->node + 1; // weights less than 0, or 0
    const int own = owners[contact->feature];
    for (int k = 0; k < 3; k++) {
        const bool here = corner[k].weight < 0, next = corner[(k + 1) % 3].weight < 0,
                   last = corner[(k + 2) % 3].weight < 0;
        if (here && !next && !last)
            return own >> k & 1;
        if (here && next && !last)
            return own >> (3 + k) & 1;
    }
    return true;
}
