#include "view/field.h"
#include "view/mode.h"

static const double MIN_AREA = 1e-25; ///< [m^2]
static const double MIN_TOP = 1e-6;   ///< lower limit of the scale's upper end [mm]

static bool fits(const Balloon* balloon) {
    return balloon->body.membrane.count > 0;
}

/// The mean thickness at a point is the volume of rubber of its elements over their area [mm].
static FieldShare element(const Membrane* membrane, const real4* x, int e) {
    const double area = membrane_share(membrane, e) * membrane_area(membrane, x, e);
    if (!(area > MIN_AREA)) // folded to a line: it weighs only where all elements are folded
        return (FieldShare){1000 * MIN_AREA * (double)membrane->first[e], MIN_AREA};
    return (FieldShare){1000 * membrane_thickness(membrane, x, e) * area, area};
}

static void measure(PictureSkin* skin, const Balloon* balloon) {
    field_of_elements(skin, &balloon->body, element, skin->field);
}

static void range(double* low, double* high) {
    // the volume rule "global" lets thicknesses drift, even below 0
    *low = *low > 0 ? field_below(*low) : *low < 0 ? -field_above(-*low) : 0;
    *high = field_above(fmax(*high, MIN_TOP));
    if (*high <= *low) // the thickness is uniform and a number of the series
        *low = field_below(0.99 * *low);
}

const Mode mode_thickness = {
    .name = "thickness",
    .about = "thickness of the rubber, from dark (thin) to bright",
    .paint = PAINT_FIELD,
    .fits = fits,
    .measure = measure,
    .range = range,
    .unit = " mm",
};
