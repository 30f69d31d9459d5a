#include "view/skin_pen.h"

#include "view/surface.h"

const float PEN_BLACK[3] = {0.01f, 0.01f, 0.012f};
const float PEN_RED[3] = {0.72f, 0.02f, 0.02f};
const float PEN_BLUE[3] = {0.02f, 0.1f, 0.8f};
const float PEN_GREEN[3] = {0.02f, 0.42f, 0.06f};
const float PEN_ORANGE[3] = {0.85f, 0.28f, 0.01f};

static const float MIN_WIDTH_SCALE = 0.4f, MAX_WIDTH_SCALE = 1.6f;

SkinPen skin_pen_on(Picture* picture, const PictureSkin* skin, const Balloon* balloon) {
    const Camera* camera = &picture->camera;
    SkinPen pen = {.picture = picture, .skin = skin, .edge_length = surface_edge_length(balloon)};
    camera_eye(camera, pen.eye);

    // length of a mean edge at the target's depth, in pixels of a 720-line picture
    const float edge = 360 * pen.edge_length / (camera->distance * tanf(camera->field / 2));
    pen.width_scale = fminf(fmaxf(edge / PEN_EDGE, MIN_WIDTH_SCALE), MAX_WIDTH_SCALE);
    return pen;
}

bool skin_pen_hidden(const SkinPen* pen, int i) {
    if (pen->skin->two_sided)
        return false;
    const float *p = pen->skin->position[i], *n = pen->skin->normal[i];
    float toward = 0;
    for (int k = 0; k < 3; k++)
        toward += n[k] * (pen->eye[k] - p[k]);
    return toward < 0;
}

void skin_pen_above(const SkinPen* pen, int i, float raise, float out[3]) {
    for (int k = 0; k < 3; k++)
        out[k] = pen->skin->position[i][k] + raise * pen->edge_length * pen->skin->normal[i][k];
}

void skin_pen_line(const SkinPen* pen, const int end[2], float raise, const float color[3],
                   float width) {
    if (skin_pen_hidden(pen, end[0]) && skin_pen_hidden(pen, end[1]))
        return;
    float from[3], to[3];
    skin_pen_above(pen, end[0], raise, from);
    skin_pen_above(pen, end[1], raise, to);
    picture_line(pen->picture, from, to, color, pen->width_scale * width);
}
