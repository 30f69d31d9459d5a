#include <string.h>

#include "view/mode.h"

static void measure(PictureSkin* skin, const Balloon* balloon) {
    (void)balloon;
    memcpy(skin->field, skin->stretch, (size_t)skin->point_count * sizeof *skin->field);
}

/// From 1 to 1.1, 1.2, 1.4, 1.8, 2.6, …: the excess over 1 doubles.
static void range(double* low, double* high) {
    double top = 1.1;
    while (top < *high)
        top = 1 + 2 * (top - 1);
    *low = 1;
    *high = top;
}

const Mode mode_stretch = {
    .name = "stretch",
    .about = "length over rest length; for rubber the larger principal stretch; dark to bright",
    .paint = PAINT_FIELD,
    .measure = measure,
    .range = range,
    .unit = "",
};
