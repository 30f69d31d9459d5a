#include "world/things/balls.h"

#include "contact/ball_start.h"

void balls_begin(World* world) {
    const WorldDef* def = &world->def;
    for (unsigned s = 0; s < def->spheres_count; s++) {
        const SphereDef* ball = &def->spheres[s];
        const double none[3] = {0};
        Sphere sphere = sphere_of(ball->position, ball->velocity ? ball->velocity : none,
                                  ball->radius, ball->mass, ball->restitution, ball->friction);
        const int skin = ball_start_clear(&sphere, &world->contacts);
        const bool thing = skin >= world->balloon_count;
        if (skin != NONE)
            snprintf(world->notice, sizeof world->notice,
                     "spheres.%u begins across %s.%d; it was moved to %.3g, %.3g, %.3g", s,
                     thing ? "things" : "the skin of balloons",
                     thing ? skin - world->balloon_count : skin, (double)sphere.x[0],
                     (double)sphere.x[1], (double)sphere.x[2]);
        contacts_add(&world->contacts, &sphere);
    }
}
