#include "view/spheres.h"

#include <math.h>

#include "view/color.h"

// sRGB; neighbors differ in brightness as well as in hue
static const float PALETTE[][3] = {
    {0.95f, 0.90f, 0.80f}, {0.10f, 0.22f, 0.55f}, {0.96f, 0.62f, 0.10f}, {0.08f, 0.42f, 0.38f},
    {0.94f, 0.45f, 0.42f}, {0.20f, 0.18f, 0.22f}, {0.55f, 0.78f, 0.92f}, {0.56f, 0.12f, 0.28f},
    {0.70f, 0.85f, 0.35f}, {0.38f, 0.24f, 0.62f},
};
enum { COLORS = sizeof PALETTE / sizeof *PALETTE };

// A ball is near a scene up to this distance from its center. [half diagonals of its box]
static const float NEAR = 2;

void spheres_add(Picture* picture, const World* world) {
    for (int s = 0; s < world->contacts.sphere_count; s++) {
        const Sphere* sphere = &world->contacts.sphere[s];
        const float center[3] = {(float)sphere->x[0], (float)sphere->x[1], (float)sphere->x[2]};
        float color[3];
        color_linear(PALETTE[s % COLORS], color);
        picture_ball(picture, center, (float)sphere->radius, color);
    }
}

void spheres_widen(const World* world, float low[3], float high[3]) {
    double4 middle = {0}, half = {0};
    for (int k = 0; k < 3; k++) {
        half[k] = 0.5 * ((double)high[k] - (double)low[k]);
        middle[k] = (double)low[k] + half[k];
    }
    const double reach = (double)NEAR * dlength(half);
    for (int s = 0; s < world->contacts.sphere_count; s++) {
        const Sphere* sphere = &world->contacts.sphere[s];
        if (!(dlength(to_double4(sphere->x) - middle) <= reach))
            continue;
        for (int k = 0; k < 3; k++) {
            low[k] = fminf(low[k], (float)(sphere->x[k] - sphere->radius));
            high[k] = fmaxf(high[k], (float)(sphere->x[k] + sphere->radius));
        }
    }
}
