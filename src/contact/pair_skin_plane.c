#include "contact/pair.h"

static bool stop(Contacts* contacts, double h) {
    bool any = false;
    for (int b = 0; contacts->plane_count > 0 && b < contacts->skin_count; b++) {
        Body* body = contacts->skin[b].body;
        if (body->asleep)
            continue;
        const Extent x = extent_of(body->x, body->count), v = extent_of(body->v, body->count);
        for (int k = 0; k < contacts->plane_count; k++)
            if (plane_within(&contacts->plane[k], &x, &v, h))
                any |= plane_stop(body, &contacts->plane[k], h);
    }
    return any;
}

const PairRow pair_skin_plane = {
    .name = "skin-plane",
    .about = "a skin's particles and the floor or a wall, each particle in closed form",
    .stop = stop,
};
