#include "mesh/shapes/solids.h"

#include "mesh/mesh.h"
#include "mesh/shapes/circle.h"

/// The profile of a capsule, from the upper pole to the lower one: `cap` rings of the upper hemisphere,
/// `along` steps down the straight part, and the lower hemisphere. Poles are rings without a radius.
typedef struct Profile {
    int cap, along;
} Profile;

static int rings_of(Profile profile) {
    return 2 * profile.cap + profile.along - 1; // without the poles
}

/// Radius and height of ring k, from 1 to rings_of(profile); 0 and one more are the poles.
static CirclePoint ring_of(Profile profile, int k) {
    const int last = rings_of(profile) + 1;
    if (k > last - k) {
        const CirclePoint mirrored = ring_of(profile, last - k);
        return (CirclePoint){.cosine = -mirrored.cosine, .sine = mirrored.sine};
    }
    if (k >= profile.cap)
        return (CirclePoint){.cosine = 1 - 2.0 * (k - profile.cap) / profile.along, .sine = 1};
    CirclePoint p = circle_point(k, 4 * profile.cap);
    p.cosine += 1;
    return p;
}

/// Points ring after ring, then the two poles; between two rings a quad for each step around.
void solid_capsule(MeshSource* source, int around, int along) {
    const Profile profile = {.cap = (around + 3) / 4, .along = along};
    const int rings = rings_of(profile), top = rings * around, bottom = top + 1;
    source_make(source, NULL, top + 2, (rings + 1) * around);
    source->point[top] = (double4){0, 2, 0, 0};
    source->point[bottom] = (double4){0, -2, 0, 0};
    int(*face)[4] = source->face;
    for (int k = 0; k <= rings; k++)
        for (int i = 0; i < around; i++, face++) {
            const int next = (i + 1) % around, upper = (k - 1) * around, lower = k * around;
            if (k < rings) {
                const CirclePoint ring = ring_of(profile, k + 1), spoke = circle_point(i, around);
                source->point[lower + i] =
                    (double4){ring.sine * spoke.cosine, ring.cosine, -ring.sine * spoke.sine, 0};
            }
            const int corner[4] = {k > 0 ? upper + i : top, k < rings ? lower + i : bottom,
                                   k < rings ? lower + next : upper + next,
                                   k > 0 && k < rings ? upper + next : NONE};
            for (int c = 0; c < 4; c++)
                (*face)[c] = corner[c];
        }
}
