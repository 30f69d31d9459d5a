/// The picture: skins, strings, balls and the camera follow from the world.
#include "studio.h"
#include "view/string_lines.h"

static void normals_are_unit_and_point_outward(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "cube-sphere:8");
    const PictureSkin* skin = &studio.picture.skin[0];
    for (int i = 0; i < skin->point_count; i++) {
        // single precision, one square root and one division
        assert_near(dot3(skin->normal[i], skin->normal[i]), 1, 1e-6);

        // the shape is centerd on the origin; the faces around a point of a sphere of eight quads a
        // side lean at most half a quad, some 6 degrees, from the radius
        const double radius = sqrt(dot3(skin->position[i], skin->position[i]));
        assert_less(0.99, dot3(skin->normal[i], skin->position[i]) / radius);
    }
    studio_close(&studio);
}

static void at_rest_nothing_is_stretched(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "squirrel.obj", "balloons.0.size=3", "balloons.0.turn=30");
    const PictureSkin* skin = &studio.picture.skin[0];
    for (int i = 0; i < skin->point_count; i++)
        // edges of a hundredth of the positions they are the differences of, in float
        assert_near((double)skin->stretch[i], 1, TOLERANCE(1e-4, 1e-6));
    studio_close(&studio);
}

static void twice_the_size_is_a_stretch_of_two(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "torus:12x8");
    Body* body = &studio.world.balloon[0].body;
    for (int i = 0; i < body->count; i++)
        body->x[i] *= 2;
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    for (int i = 0; i < body->count; i++)
        assert_near((double)studio.picture.skin[0].stretch[i], 2, TOLERANCE(1e-5, 1e-6));
    studio_close(&studio);
}

static void a_string_is_drawn_from_its_particle_to_its_fixed_end(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    const String* string = &studio.world.balloon[0].body.string[0];
    const Picture* picture = &studio.picture;
    const float anchor[3] = {(float)string->anchor[0], (float)string->anchor[1],
                             (float)string->anchor[2]};
    assert_int_equal(picture->line_count, STRING_SEGMENTS);
    assert_near(distance(picture->line[0].from, picture->skin[0].position[string->particle]), 0, 0);
    assert_near(distance(picture->line[STRING_SEGMENTS - 1].to, anchor), 0, 1e-5);
    for (int s = 1; s < STRING_SEGMENTS; s++)
        assert_near(distance(picture->line[s - 1].to, picture->line[s].from), 0, 0);
    studio_close(&studio);
}

static double drawn_length(const Picture* picture) {
    double sum = 0;
    for (int s = 0; s < picture->line_count; s++)
        sum += distance(picture->line[s].from, picture->line[s].to);
    return sum;
}

static void a_slack_string_keeps_its_length(void** state) {
    (void)state;
    for (int percent = 100; percent <= 120; percent += 5) {
        char slack[64];
        snprintf(slack, sizeof slack, "balloons.0.strings.0.slack=%g", percent / 100.0);
        Studio studio;
        STUDIO(&studio, "tether", slack);
        const double want = (double)studio.world.balloon[0].body.string[0].free_length;
        // the sag is exact for a shallow parabola: a slack of 20 % is 1 % off
        assert_close(drawn_length(&studio.picture), want, 0.015);
        studio_close(&studio);
    }
}

static void a_slack_string_lies_on_the_floor(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether", "balloons.0.strings.0.to=[3, -4, 0]", "balloons.0.strings.0.slack=2");
    for (int s = 0; s < studio.picture.line_count; s++)
        assert_true(studio.picture.line[s].to[1] >= studio.picture.floor_height);
    studio_close(&studio);
}

static void a_picture_changes_no_bit_of_the_world(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    const uint64_t before = world_hash(&studio.world);
    for (int m = 0; m < mode_count; m++)
        picture_update(&studio.picture, &studio.world, &studio.camera, mode_table[m]);
    assert_true(world_hash(&studio.world) == before);
    studio_close(&studio);
}

/// The string key adds a string to a balloon without one: the picture has the capacity to draw it.
static void a_string_tied_later_is_drawn(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "cube", "balloons.0.strings=[]");
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    const int before = studio.picture.line_count;
    balloon_tie(&studio.world.balloon[0], &studio.world.def, true);
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    assert_true(studio.picture.line_count > before);
    studio_close(&studio);
}

static void the_scene_lies_within_its_radius(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "party");
    for (int b = 0; b < studio.picture.skin_count; b++)
        for (int i = 0; i < studio.picture.skin[b].point_count; i++)
            assert_true(distance(studio.picture.skin[b].position[i], studio.picture.scene_center) <=
                        (double)studio.picture.scene_radius * (1 + 1e-6));
    studio_close(&studio);
}

static bool shows_ball(const Picture* picture, double x, double y, double z, double radius) {
    const float center[3] = {(float)x, (float)y, (float)z};
    for (int b = 0; b < picture->ball_count; b++)
        if (distance(picture->ball[b].center, center) < 1e-5 &&
            fabs((double)picture->ball[b].radius - radius) < 1e-6)
            return true;
    return false;
}

/// Balls of the scene and a growing number of thrown ones, in every mode.
static void every_ball_is_drawn_in_every_mode(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether", "spheres=[{position: [3, 0, 0], radius: 0.5, mass: 1}]");
    assert_true(shows_ball(&studio.picture, 3, 0, 0, 0.5));
    for (int n = 1; n <= 40; n++) {
        throw_at(&studio.world, -3, 0.3 * n, 0, 0.1);
        const Mode* mode = mode_table[n % mode_count];
        picture_update(&studio.picture, &studio.world, &studio.camera, mode);
        assert_true(shows_ball(&studio.picture, 3, 0, 0, 0.5));
        for (int k = 1; k <= n; k++)
            assert_true(shows_ball(&studio.picture, -3, 0.3 * k, 0, 0.1));
    }
    const PictureBall* room = studio.picture.ball;
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    assert_ptr_equal(studio.picture.ball, room);
    studio_close(&studio);
}

static void a_ball_widens_the_scene_unless_it_has_flown_away(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    const float before = studio.picture.scene_radius;
    throw_at(&studio.world, 1e4, 0, 0, 0.5);
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    assert_near((double)studio.picture.scene_radius, (double)before, 0);
    const Camera camera = framing_all(&studio.world);
    assert_near((double)camera.distance, (double)studio.camera.distance, 0);

    throw_at(&studio.world, 4, 0, 0, 0.5);
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    const float center[3] = {4, 0, 0};
    assert_less((double)before, (double)studio.picture.scene_radius);
    assert_true(distance(center, studio.picture.scene_center) <=
                (double)studio.picture.scene_radius);
    assert_less((double)camera.distance, (double)framing_all(&studio.world).distance);
    studio_close(&studio);
}

static long stamp_after(Studio* studio, const Mode* mode) {
    picture_update(&studio->picture, &studio->world, &studio->camera, mode);
    return studio->picture.stamp;
}

/// The renderer uploads a picture if its stamp is new, and only then.
static void a_picture_has_a_new_stamp_when_it_is_another(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    long last = studio.picture.stamp;
    assert_true(last > 0);
    assert_int_equal(stamp_after(&studio, &mode_skin), last);
    camera_orbit(&studio.camera, 0.1F, 0); // a camera move needs no upload
    assert_int_equal(stamp_after(&studio, &mode_skin), last);

    world_step(&studio.world);
    assert_true(stamp_after(&studio, &mode_skin) > last);
    last = studio.picture.stamp;
    studio.world.selected = 0;
    assert_true(stamp_after(&studio, &mode_skin) > last);
    last = studio.picture.stamp;
    assert_true(stamp_after(&studio, &mode_stretch) > last);
    last = studio.picture.stamp;
    assert_int_equal(stamp_after(&studio, &mode_stretch), last);
    const Sphere ball = {.x = {0, 3, 0}, .radius = 1, .mass = 1};
    contacts_add(&studio.world.contacts, &ball);
    assert_true(stamp_after(&studio, &mode_stretch) > last);
    last = studio.picture.stamp;
    studio.world.contacts.sphere[0].x[1] = 4;
    assert_true(stamp_after(&studio, &mode_stretch) > last);
    last = studio.picture.stamp;
    contacts_clear(&studio.world.contacts);
    assert_true(stamp_after(&studio, &mode_stretch) > last);
    studio_close(&studio);
}

/// A box has flat faces and moves along its path; the ghost's balloon is drawn behind it.
static void a_thing_is_opaque_and_has_sharp_edges(void** state) {
    (void)state;
    Studio studio, other;
    const char* const words[] = {
        "cube",
        "things=[{model: box, path: [{position: [3, 0, 0]}, {at: 1, position: [4, 0, 0]}]}]",
        "units=si", "gravity=0", NULL};
    studio_open(&studio, words);
    studio_open(&other, words);
    picture_ghost(&studio.picture, &other.world);
    assert_int_equal(studio.picture.skin_count, 3);
    const PictureSkin* skin = &studio.picture.skin[1];
    assert_int_equal(skin->point_count, 36);
    assert_int_equal(skin->paint, PAINT_FIELD);
    const float before = skin->position[0][0];
    run_for(&studio.world, 1);
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    assert_near((double)(skin->position[0][0] - before), 1, 1e-5);
    const float center[3] = {4, 0, 0};
    for (int i = 0; i < 36; i++) {
        float from[3];
        for (int k = 0; k < 3; k++)
            from[k] = skin->position[i][k] - center[k];
        assert_near(dot3(skin->normal[i], from), 0.5, 1e-5); // of length 1 along an axis
    }
    assert_int_equal(studio.picture.skin[2].paint, PAINT_GHOST);
    assert_near((double)studio.picture.skin[2].position[0][0],
                (double)studio.picture.skin[0].position[0][0], 0.5);
    studio_close(&studio);
    studio_close(&other);
}

static void the_scenes_camera_stands_where_it_says(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "cube", "camera={eye: [4, 3, -2], look: [1, 0.5, 0]}");
    const float want[3] = {4, 3, -2}, look[3] = {1, 0.5f, 0};
    float eye[3];
    camera_eye(&studio.camera, eye);
    assert_near(distance(eye, want), 0, 1e-5); // sines and cosines in float
    assert_near(distance(studio.camera.target, look), 0, 1e-6);
    studio_close(&studio);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_are_unit_and_point_outward),
        cmocka_unit_test(at_rest_nothing_is_stretched),
        cmocka_unit_test(twice_the_size_is_a_stretch_of_two),
        cmocka_unit_test(a_string_is_drawn_from_its_particle_to_its_fixed_end),
        cmocka_unit_test(a_slack_string_keeps_its_length),
        cmocka_unit_test(a_slack_string_lies_on_the_floor),
        cmocka_unit_test(a_picture_changes_no_bit_of_the_world),
        cmocka_unit_test(a_string_tied_later_is_drawn),
        cmocka_unit_test(the_scene_lies_within_its_radius),
        cmocka_unit_test(every_ball_is_drawn_in_every_mode),
        cmocka_unit_test(a_ball_widens_the_scene_unless_it_has_flown_away),
        cmocka_unit_test(a_picture_has_a_new_stamp_when_it_is_another),
        cmocka_unit_test(a_thing_is_opaque_and_has_sharp_edges),
        cmocka_unit_test(the_scenes_camera_stands_where_it_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
