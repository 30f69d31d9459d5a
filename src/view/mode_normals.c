#include "view/mode.h"

#include "view/color.h"
#include "view/skin_pen.h"

static const float WIDTH = 1.1f;  // [px at 720 lines]
static const float LENGTH = 0.8f; // [edge lengths]

static void fill(Picture* picture, PictureSkin* skin, const Balloon* balloon) {
    const SkinPen pen = skin_pen_on(picture, skin, balloon);
    for (int i = 0; i < skin->point_count; i++) {
        // the components -1…1 along x, y, z become red, green, blue
        float shade[3], tip[3];
        for (int k = 0; k < 3; k++)
            shade[k] = 0.5f + 0.5f * skin->normal[i][k];
        color_linear(shade, skin->tint[i]);

        skin_pen_above(&pen, i, LENGTH, tip);
        if (!skin_pen_hidden(&pen, i))
            picture_line(picture, skin->position[i], tip, PEN_BLACK, pen.width_scale * WIDTH);
    }
}

static int lines(const Balloon* balloon) {
    return balloon->mesh.point_count;
}

const Mode mode_normals = {
    .name = "normals",
    .about = "the outward normal, as color and as hairs",
    .paint = PAINT_FIELD,
    .fill = fill,
    .lines = lines,
};
