#include "view/mode.h"
#include "view/skin_pen.h"

static const float WIDTH = 1.1f;  // [px at 720 lines]
static const float RAISE = 0.02f; // [edge lengths]

static void fill(Picture* picture, PictureSkin* skin, const Balloon* balloon) {
    const SkinPen pen = skin_pen_on(picture, skin, balloon);
    for (int e = 0; e < balloon->mesh.edge_count; e++)
        skin_pen_line(&pen, balloon->mesh.edge[e], RAISE, PEN_BLACK, WIDTH);
}

static int lines(const Balloon* balloon) {
    return balloon->mesh.edge_count;
}

const Mode mode_quads = {
    .name = "quads",
    .about = "the rubber with the edges of its mesh",
    .paint = PAINT_RUBBER,
    .fill = fill,
    .lines = lines,
};
