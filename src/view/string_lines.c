#include "view/string_lines.h"

static const float STRING_COLOR[3] = {0.30f, 0.29f, 0.30f};
static const float STRING_WIDTH = 1.8f; // [px at 720 lines]
// [of the balloon's size]
static const float KNOT_RADIUS = 0.018f;
// A slack vertical string bows slightly to one side, as a real one does.
static const double4 SIDEWAYS = {0.8, 0, 0.6, 0};
static const double SIDEWAYS_SHARE = 0.25;

/// The unit direction of a slack string's sag: down and slightly sideways, normal to its chord.
static double4 bow_direction(double4 chord) {
    const double4 down = {0, -1, 0, 0};
    const double4 pull = down + SIDEWAYS_SHARE * SIDEWAYS;
    const double square = ddot(chord, chord);
    const double4 across = square > 0 ? pull - (ddot(pull, chord) / square) * chord : pull;
    const double size = dlength(across);
    return size > 0 ? across / size : SIDEWAYS;
}

/// The sag s of a parabola of length l over a chord d. A shallow one has l = d + 8 s^2 / (3 d), one
/// without a chord l = 2 s; s^2 = 3/16 (l^2 - d^2) satisfies the first and approximates the second.
static double sag(double free_length, double chord) {
    const double square = 3.0 / 16.0 * (free_length * free_length - chord * chord);
    return square > 0 ? sqrt(square) : 0;
}

static void add_string(Picture* picture, double4 from, double4 to, double free_length, float knot) {
    const double depth = sag(free_length, dlength(to - from));
    const double4 bow = 4 * depth * bow_direction(to - from);

    float before[3], now[3];
    for (int s = 0; s <= STRING_SEGMENTS; s++) {
        const double t = (double)s / STRING_SEGMENTS;
        const double4 p = from + t * (to - from) + t * (1 - t) * bow;
        for (int k = 0; k < 3; k++)
            now[k] = (float)p[k];
        if (picture->floor && s > 0 && s < STRING_SEGMENTS)
            now[1] = fmaxf(now[1], picture->floor_height + 0.3f * knot);
        if (s > 0)
            picture_line(picture, before, now, STRING_COLOR, STRING_WIDTH);
        else
            picture_ball(picture, now, knot, STRING_COLOR);
        for (int k = 0; k < 3; k++)
            before[k] = now[k];
    }
    picture_ball(picture, now, knot, STRING_COLOR);
}

void string_lines_add(Picture* picture, const Balloon* balloon) {
    const Body* body = &balloon->body;
    for (int s = 0; s < body->string_count; s++) {
        const String* string = &body->string[s];
        add_string(picture, to_double4(body->x[string->particle]), to_double4(string->anchor),
                   (double)string->free_length, KNOT_RADIUS * (float)body->size);
    }
}

void string_lines_add_joints(Picture* picture, const World* world) {
    const Joints* joints = &world->system.joints;
    for (int k = 0; k < joints->count; k++) {
        const Joint* joint = &joints->joint[k];
        const double size = joints->body[joint->end[0].body]->size;
        if (joint->tied)
            add_string(picture, to_double4(joint_position(joints, joint->end[0], 0)),
                       to_double4(joint_position(joints, joint->end[1], 0)),
                       (double)joint->free_length, KNOT_RADIUS * (float)size);
    }
}
