#include "view/mode.h"

#include "view/color.h"

static const float TOP_LEAST = 1.1f;

float mode_stretch_top(const Picture* picture) {
    float most = 1;
    for (int b = 0; b < picture->skin_count; b++)
        for (int i = 0; i < picture->skin[b].point_count; i++)
            most = fmaxf(most, picture->skin[b].stretch[i]);

    // 1.1, 1.2, 1.4, 1.8, 2.6, …: the part above 1 doubles
    float top = TOP_LEAST;
    while (top < most)
        top = 1 + 2 * (top - 1);
    return top;
}

static void fill(Picture* picture, PictureSkin* skin, const Balloon* balloon) {
    (void)balloon;
    const float range = mode_stretch_top(picture) - 1;
    for (int i = 0; i < skin->point_count; i++)
        color_scale((skin->stretch[i] - 1) / range, skin->tint[i]);
}

const Mode mode_stretch = {
    .name = "stretch",
    .about = "length over rest length, from dark (at rest) to bright",
    .paint = PAINT_FIELD,
    .fill = fill,
};
