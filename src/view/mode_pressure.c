#include "mesh/measure.h"
#include "view/field.h"
#include "view/mode.h"
#include "view/skin_pen.h"

// Figure 5 of the thin-shell balloon paper: where the skin is strongly curved, the pressure forces
// of the faces around a particle partly cancel, and their sum is smaller.
static const float LENGTH = 2.0f; // the longest hair [edge lengths]
static const float WIDTH = 1.0f;  // [px at 720 lines]

enum { MAX_HAIRS = 4000 }; ///< with more particles, hairs would hide the colors

static bool fits(const Balloon* balloon) {
    return balloon->body.inflation.law != INFLATE_NONE;
}

/// The pressure force p dV/dx on a particle [N].
static double4 pressure_force(const Balloon* balloon, double pressure, int i) {
    return pressure * measure_volume_gradient_at(&balloon->mesh, balloon->body.x, i);
}

static void measure(PictureSkin* skin, const Balloon* balloon) {
    const double pressure = balloon_pressure(balloon);
    for (int i = 0; i < skin->point_count; i++)
        skin->field[i] = (float)dlength(pressure_force(balloon, pressure, i));
}

static void range(double* low, double* high) {
    *low = 0;
    *high = *high > 0 ? field_above(*high) : 1;
}

static int lines(const Balloon* balloon) {
    return balloon->mesh.point_count <= MAX_HAIRS ? balloon->mesh.point_count : 0;
}

static void fill(Picture* picture, PictureSkin* skin, const Balloon* balloon) {
    if (lines(balloon) == 0)
        return;
    const SkinPen pen = skin_pen_on(picture, skin, balloon);
    const double pressure = balloon_pressure(balloon);
    const double scale = (double)(LENGTH * pen.edge_length / picture->range[1]);
    for (int i = 0; i < skin->point_count; i++) {
        if (skin_pen_hidden(&pen, i))
            continue;
        const double4 hair = scale * pressure_force(balloon, pressure, i);
        float tip[3];
        for (int k = 0; k < 3; k++)
            tip[k] = skin->position[i][k] + (float)hair[k];
        picture_line(picture, skin->position[i], tip, PEN_BLACK, pen.width_scale * WIDTH);
    }
}

const Mode mode_pressure = {
    .name = "pressure",
    .about = "the force of the pressure on each particle, as color and as hairs",
    .paint = PAINT_FIELD,
    .fits = fits,
    .measure = measure,
    .range = range,
    .unit = " N",
    .fill = fill,
    .lines = lines,
};
