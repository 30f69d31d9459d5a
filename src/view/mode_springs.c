#include "view/mode.h"
#include "view/stroke.h"

// figure 3 of the mass-spring paper: particles red, structural springs black, shear blue, flexion
// green. Flexion springs lie along two structural ones: they are wider and deeper, so that both
// show
static const float* const COLOR[SPRING_KINDS] = {STROKE_BLACK, STROKE_BLUE, STROKE_GREEN};
static const float WIDTH[SPRING_KINDS] = {1.3f, 1.0f, 2.6f};    // [px at 720 lines]
static const float RAISE[SPRING_KINDS] = {0.03f, 0.02f, 0.01f}; // [edge lengths]
static const float TORSION_WIDTH = 4.0f;
static const float PARTICLE_RADIUS = 0.09f; // [edge lengths]
static const float PARTICLE_RAISE = 0.08f;

enum { PARTICLE_BALLS_MOST = 4000 }; ///< with more particles, balls would hide the springs

static void particles(const Stroke* stroke) {
    for (int i = 0; i < stroke->skin->point_count; i++) {
        float center[3];
        stroke_above(stroke, i, PARTICLE_RAISE, center);
        if (!stroke_hidden(stroke, i))
            picture_ball(stroke->picture, center, PARTICLE_RADIUS * stroke->grain, STROKE_RED);
    }
}

static void fill(Picture* picture, PictureSkin* skin, const Balloon* balloon) {
    const Stroke stroke = stroke_on(picture, skin, balloon);
    const Torsion* torsion = &balloon->body.torsion;
    const Springs* springs = &balloon->body.springs;

    // the deepest first
    for (int t = 0; t < torsion->count; t++) {
        const int end[2] = {torsion->path[t][0], torsion->path[t][2]};
        stroke_line(&stroke, end, 0, STROKE_ORANGE, TORSION_WIDTH);
    }
    for (int kind = SPRING_KINDS - 1; kind >= 0; kind--)
        for (int s = springs->from[kind]; s < springs->from[kind + 1]; s++)
            stroke_line(&stroke, springs->end[s], RAISE[kind], COLOR[kind], WIDTH[kind]);

    if (skin->point_count <= PARTICLE_BALLS_MOST)
        particles(&stroke);
}

static int lines(const Balloon* balloon) {
    return balloon->body.springs.count + balloon->body.torsion.count;
}

static int balls(const Balloon* balloon) {
    const int count = balloon->mesh.point_count;
    return count <= PARTICLE_BALLS_MOST ? count : 0;
}

const Mode mode_springs = {
    .name = "springs",
    .about = "structural springs black, shear blue, flexion green, torsion orange",
    .paint = PAINT_FAINT,
    .fill = fill,
    .lines = lines,
    .balls = balls,
};
