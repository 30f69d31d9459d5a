#include "view/framing.h"

#include <float.h>

#include "view/spheres.h"

// Space around a balloon at rest, so that it can grow within the picture. [of its size]
static const float GROWTH_MARGIN = 0.15f;

static void widen(float low[3], float high[3], real4 point) {
    for (int k = 0; k < 3; k++) {
        low[k] = fminf(low[k], (float)point[k]);
        high[k] = fmaxf(high[k], (float)point[k]);
    }
}

Camera framing_all(const World* world) {
    float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX}, high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
    for (int b = 0; b < world->balloon_count; b++) {
        const Body* body = &world->balloon[b].body;
        const real margin = (real)GROWTH_MARGIN * (real)body->size;
        for (int i = 0; i < body->count; i++) {
            widen(low, high, body->x[i] - margin);
            widen(low, high, body->x[i] + margin);
        }
        for (int s = 0; s < body->string_count; s++)
            widen(low, high, body->string[s].anchor);
    }
    for (int k = 0; k < world->thing_count; k++)
        for (int i = 0; i < world->thing[k].body.count; i++)
            widen(low, high, world->thing[k].body.x[i]);
    spheres_widen(world, low, high);
    return camera_framing(low, high);
}

/// Set yaw, pitch and distance so that the eye is at `eye`.
static void set_eye(Camera* camera, const double eye[3]) {
    double offset[3], square = 0;
    for (int k = 0; k < 3; k++) {
        offset[k] = eye[k] - (double)camera->target[k];
        square += offset[k] * offset[k];
    }
    const double distance = sqrt(square);
    if (!(distance > 0))
        return;
    camera->distance = (float)distance;
    camera->yaw = (float)atan2(offset[0], offset[2]);
    camera->pitch = (float)asin(offset[1] / distance);
    camera_orbit(camera, 0, 0); // clamps the pitch
}

Camera framing_first(const World* world) {
    Camera camera = framing_all(world);
    const CameraDef* def = world->def.camera;
    if (def && def->look)
        for (int k = 0; k < 3; k++)
            camera.target[k] = (float)def->look[k];
    if (def && def->eye)
        set_eye(&camera, def->eye);
    return camera;
}
