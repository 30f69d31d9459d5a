#include "view/mode.h"
#include "view/skin_pen.h"

// Figure 3 of the mass-spring paper: particles red, structural springs black, shear blue, flexion
// green. A flexion spring lies along two structural ones: it is drawn wider and deeper, so that
// both are visible.
static const float* const COLOR[SPRING_KINDS] = {PEN_BLACK, PEN_BLUE, PEN_GREEN};
static const float WIDTH[SPRING_KINDS] = {1.3f, 1.0f, 2.6f};    // [px at 720 lines]
static const float RAISE[SPRING_KINDS] = {0.03f, 0.02f, 0.01f}; // [edge lengths]
static const float TORSION_WIDTH = 4.0f;
static const float PARTICLE_RADIUS = 0.09f; // [edge lengths]
static const float PARTICLE_RAISE = 0.08f;

enum { MAX_PARTICLE_BALLS = 4000 }; ///< with more particles, balls would hide the springs

static void particles(const SkinPen* pen) {
    for (int i = 0; i < pen->skin->point_count; i++) {
        float center[3];
        skin_pen_above(pen, i, PARTICLE_RAISE, center);
        if (!skin_pen_hidden(pen, i))
            picture_ball(pen->picture, center, PARTICLE_RADIUS * pen->edge_length, PEN_RED);
    }
}

static void fill(Picture* picture, PictureSkin* skin, const Balloon* balloon) {
    const SkinPen pen = skin_pen_on(picture, skin, balloon);
    const Torsion* torsion = &balloon->body.torsion;
    const Springs* springs = &balloon->body.springs;

    // from the deepest to the highest
    for (int t = 0; t < torsion->count; t++) {
        const int end[2] = {torsion->path[t][0], torsion->path[t][2]};
        skin_pen_line(&pen, end, 0, PEN_ORANGE, TORSION_WIDTH);
    }
    for (int kind = SPRING_KINDS - 1; kind >= 0; kind--)
        for (int s = springs->from[kind]; s < springs->from[kind + 1]; s++)
            skin_pen_line(&pen, springs->end[s], RAISE[kind], COLOR[kind], WIDTH[kind]);

    if (skin->point_count <= MAX_PARTICLE_BALLS)
        particles(&pen);
}

static int lines(const Balloon* balloon) {
    return balloon->body.springs.count + balloon->body.torsion.count;
}

static int balls(const Balloon* balloon) {
    const int count = balloon->mesh.point_count;
    return count <= MAX_PARTICLE_BALLS ? count : 0;
}

const Mode mode_springs = {
    .name = "springs",
    .about = "structural springs black, shear blue, flexion green, torsion orange",
    .paint = PAINT_FAINT,
    .fill = fill,
    .lines = lines,
    .balls = balls,
};
