#include "view/color.h"

#include <math.h>

static float linear_of(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92f : powf((srgb + 0.055f) / 1.055f, 2.4f);
}

void color_linear(const float srgb[3], float linear[3]) {
    for (int k = 0; k < 3; k++)
        linear[k] = linear_of(srgb[k]);
}

// viridis at eighths of its length, 8-bit sRGB
enum { SCALE_STEPS = 8 };
static const unsigned char SCALE[SCALE_STEPS + 1][3] = {
    {68, 1, 84},    {71, 45, 123}, {59, 82, 139},  {44, 114, 142}, {33, 145, 140},
    {40, 174, 128}, {94, 201, 98}, {173, 220, 48}, {253, 231, 37},
};

void color_scale(float t, float linear[3]) {
    const float position = fminf(fmaxf(t, 0), 1) * SCALE_STEPS;
    const int step = position < SCALE_STEPS ? (int)position : SCALE_STEPS - 1;
    const float fraction = position - (float)step;

    // interpolate in sRGB, for which the scale was designed
    for (int k = 0; k < 3; k++) {
        const float a = SCALE[step][k], b = SCALE[step + 1][k];
        linear[k] = linear_of((a + fraction * (b - a)) / 255);
    }
}
