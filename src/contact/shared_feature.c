#include "contact/shared_feature.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/point_corners.h"

unsigned char* shared_feature_owners(const Mesh* mesh) {
    unsigned char* owners = new_array(unsigned char, mesh->triangle_count);
    PointCorners corners = point_corners_open(mesh);
    for (int t = 0; t < mesh->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const int a = mesh->triangle[t][k], b = mesh->triangle[t][(k + 1) % 3];
            const int* around = corners.corner + corners.from[a];
            if (around[0] / 3 == t)
                owners[t] |= (unsigned char)(1 << k);
            while (!triangle_has(mesh->triangle[around[0] / 3], b))
                around++;
            if (around[0] / 3 == t)
                owners[t] |= (unsigned char)(8 << k);
        }
    point_corners_close(&corners);
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
