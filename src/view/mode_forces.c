#include "view/mode.h"

#include "force/helium.h"
#include "view/skin_pen.h"

// Figure 26 of the mass-spring paper: the net force on each particle.
static const double MAX_LENGTH = 4.0;        // no arrow is longer [edge lengths]
static const double HALF_LENGTH_FORCE = 2.0; // force of an arrow of half that length [mean forces]
static const float WIDTH = 1.5f;             // [px at 720 lines]
static const double HEAD = 0.25;             // [of the arrow's length]
static const double SPREAD = 0.35;           // half width of the head over its length
// The scale is never below this share of a particle's weight or lift: at rest the arrows then
// shrink to nothing rather than magnify rounding errors. [1]
static const double MIN_WEIGHT_SHARE = 0.25;

/// The force scale of the arrows. [N]
static double force_scale(const Body* body) {
    double sum = 0;
    for (int i = 0; i < body->count; i++)
        sum += (double)length(body->f[i]);
    const double lift = fabs(helium_acceleration(body)), weight = body->gravity;
    return fmax(sum / body->count, MIN_WEIGHT_SHARE * (double)body->mass[0] * fmax(lift, weight));
}

/// A shaft and two barbs in the plane that faces the eye.
static void arrow(const SkinPen* pen, const float from[3], double4 along, const float color[3]) {
    const float width = pen->width_scale * WIDTH;
    const double4 tip = (double4){from[0], from[1], from[2], 0} + along;
    const float to[3] = {(float)tip[0], (float)tip[1], (float)tip[2]};
    picture_line(pen->picture, from, to, color, width);

    const double4 sight = (double4){pen->eye[0], pen->eye[1], pen->eye[2], 0} - tip;
    const double4 across = dcross(along, sight);
    const double size = dlength(across);
    if (!(size > 0))
        return;
    for (int side = -1; side <= 1; side += 2) {
        const double4 wide = SPREAD * side * dlength(along) / size * across;
        const double4 barb = tip - HEAD * (along + wide);
        const float end[3] = {(float)barb[0], (float)barb[1], (float)barb[2]};
        picture_line(pen->picture, to, end, color, width);
    }
}

static bool outward(const float normal[3], real4 force) {
    return dot(force, (real4){normal[0], normal[1], normal[2], 0}) > 0;
}

/// length = MAX_LENGTH f / (f + half): a saturating scale, so that the large force at a string does
/// not make all other arrows invisible.
static void fill(Picture* picture, PictureSkin* skin, const Balloon* balloon) {
    const Body* body = &balloon->body;
    const double half = HALF_LENGTH_FORCE * force_scale(body);
    if (!(half > 0))
        return;
    const SkinPen pen = skin_pen_on(picture, skin, balloon);
    for (int i = 0; i < skin->point_count; i++) {
        const double force = (double)length(body->f[i]);
        const double scale = MAX_LENGTH * (double)pen.edge_length / (force + half);
        arrow(&pen, skin->position[i], scale * to_double4(body->f[i]),
              outward(skin->normal[i], body->f[i]) ? PEN_RED : PEN_BLUE);
    }
}

static int lines(const Balloon* balloon) {
    return 3 * balloon->mesh.point_count;
}

const Mode mode_forces = {
    .name = "forces",
    .about = "the net force on each particle: red outward, blue inward",
    .paint = PAINT_FAINT,
    .fill = fill,
    .lines = lines,
};
