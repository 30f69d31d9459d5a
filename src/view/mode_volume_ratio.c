#include "view/field.h"
#include "view/mode.h"

static const double MIN_HALF = 0.001; ///< lower limit of half a range: rounding is not magnified

static bool fits(const Balloon* balloon) {
    return balloon->body.membrane.count > 0;
}

/// The present volume of rubber of a point's elements over their volume at rest.
static FieldShare element(const Membrane* membrane, const real4* x, int e) {
    const double area = membrane_share(membrane, e) * membrane_area(membrane, x, e);
    const double now = area > 0 ? area * membrane_thickness(membrane, x, e) : 0;
    return (FieldShare){now, (double)membrane->rest[e][3]};
}

static void measure(PictureSkin* skin, const Balloon* balloon) {
    field_of_elements(skin, &balloon->body, element, skin->field);
}

/// Symmetric about 1.
static void range(double* low, double* high) {
    const double half = field_above(fmax(fmax(1 - *low, *high - 1), MIN_HALF));
    *low = 1 - half;
    *high = 1 + half;
}

const Mode mode_volume_ratio = {
    .name = "volume-ratio",
    .about = "volume of rubber over that at rest; varies only with volume rule global",
    .paint = PAINT_FIELD,
    .fits = fits,
    .measure = measure,
    .range = range,
    .unit = "",
};
