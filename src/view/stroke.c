#include "view/stroke.h"

#include "view/surface.h"

const float STROKE_BLACK[3] = {0.01f, 0.01f, 0.012f};
const float STROKE_RED[3] = {0.72f, 0.02f, 0.02f};
const float STROKE_BLUE[3] = {0.02f, 0.1f, 0.8f};
const float STROKE_GREEN[3] = {0.02f, 0.42f, 0.06f};
const float STROKE_ORANGE[3] = {0.85f, 0.28f, 0.01f};

static const float THIN_LEAST = 0.4f, THIN_MOST = 1.6f;

Stroke stroke_on(Picture* picture, const PictureSkin* skin, const Balloon* balloon) {
    const Camera* camera = &picture->camera;
    Stroke stroke = {.picture = picture, .skin = skin, .grain = surface_grain(balloon)};
    camera_eye(camera, stroke.eye);

    // an edge at the skin's own size and the target's depth, in pixels of a 720-line picture
    const float edge = 360 * stroke.grain / (camera->distance * tanf(camera->field / 2));
    stroke.thin = fminf(fmaxf(edge / STROKE_EDGE, THIN_LEAST), THIN_MOST);
    return stroke;
}

bool stroke_hidden(const Stroke* stroke, int i) {
    if (stroke->skin->two_sided)
        return false;
    const float *p = stroke->skin->position[i], *n = stroke->skin->normal[i];
    float toward = 0;
    for (int k = 0; k < 3; k++)
        toward += n[k] * (stroke->eye[k] - p[k]);
    return toward < 0;
}

void stroke_above(const Stroke* stroke, int i, float raise, float out[3]) {
    for (int k = 0; k < 3; k++)
        out[k] = stroke->skin->position[i][k] + raise * stroke->grain * stroke->skin->normal[i][k];
}

void stroke_line(const Stroke* stroke, const int end[2], float raise, const float color[3],
                 float width) {
    if (stroke_hidden(stroke, end[0]) && stroke_hidden(stroke, end[1]))
        return;
    float from[3], to[3];
    stroke_above(stroke, end[0], raise, from);
    stroke_above(stroke, end[1], raise, to);
    picture_line(stroke->picture, from, to, color, stroke->thin * width);
}
