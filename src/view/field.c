#include "view/field.h"

#include <string.h>

#include "view/color.h"

static void widen(const PictureSkin* skin, double* low, double* high) {
    for (int i = 0; i < skin->point_count; i++) {
        *low = fmin(*low, (double)skin->field[i]);
        *high = fmax(*high, (double)skin->field[i]);
    }
}

/// Returns whether any color has changed.
static bool tint(PictureSkin* skin, const float range[2]) {
    bool changed = false;
    for (int i = 0; i < skin->point_count; i++) {
        float color[3];
        color_scale((skin->field[i] - range[0]) / (range[1] - range[0]), color);
        changed |= memcmp(color, skin->tint[i], sizeof color) != 0;
        memcpy(skin->tint[i], color, sizeof color);
    }
    return changed;
}

void field_update(Picture* picture, const World* world, const Mode* mode) {
    double low = INFINITY, high = -INFINITY;
    for (int b = 0; b < world->balloon_count; b++)
        if (mode_fits(mode, &world->balloon[b])) {
            mode->measure(&picture->skin[b], &world->balloon[b]);
            widen(&picture->skin[b], &low, &high);
        }

    picture->range[0] = picture->range[1] = 0;
    if (low > high)
        return;
    mode->range(&low, &high);
    picture->range[0] = (float)low;
    picture->range[1] = (float)high;
    for (int b = 0; b < world->balloon_count; b++)
        if (mode_fits(mode, &world->balloon[b]))
            picture->changed |= tint(&picture->skin[b], picture->range);
}

void field_of_elements(PictureSkin* skin, const Body* body, ElementField* element, float* out) {
    const Membrane* membrane = &body->membrane;
    memset(out, 0, (size_t)skin->point_count * sizeof *out);
    memset(skin->weight, 0, (size_t)skin->point_count * sizeof *skin->weight);
    for (int e = 0; e < membrane->count; e++) {
        const FieldShare share = element(membrane, body->x, e);
        for (int k = 0; k < 3; k++) {
            out[membrane->corner[e][k]] += (float)share.amount;
            skin->weight[membrane->corner[e][k]] += (float)share.weight;
        }
    }
    for (int i = 0; i < skin->point_count; i++)
        out[i] /= skin->weight[i];
}

static const double STEPS[] = {1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10};
enum { STEP_COUNT = sizeof STEPS / sizeof *STEPS };
static const double ROUNDING = 1e-4; ///< far above float's rounding, far below a visible change

double field_above(double x) {
    const double ten = pow(10, floor(log10(x)));
    int k = 0;
    while (k < STEP_COUNT - 1 && STEPS[k] * ten < x * (1 - ROUNDING))
        k++;
    return STEPS[k] * ten;
}

double field_below(double x) {
    const double ten = pow(10, floor(log10(x)));
    int k = STEP_COUNT - 1;
    while (k > 0 && STEPS[k] * ten > x * (1 + ROUNDING))
        k--;
    return STEPS[k] * ten;
}
