/// The picture: what is drawn follows from the world, in every display mode.
#include "worlds.h"

#include "force/force.h"
#include "view/color.h"
#include "view/field.h"
#include "view/framing.h"
#include "view/mode.h"
#include "view/picture.h"
#include "view/rope.h"
#include "view/status.h"

/// One balloon of rubber, as the words of a scene: `more` are further keys of the membrane.
#define RUBBER(model, more)                                                                        \
    "peak", "balloons=[{model: " model ", skin: {membrane: {material: neo-hookean, young: 1e6, "   \
            "density: 1000, thickness: 3e-4" more "}}}]"

typedef struct Studio {
    World world;
    Camera camera;
    Picture picture;
} Studio;

static void studio_open(Studio* studio, const char* const* words) {
    *studio = (Studio){0};
    world_of_list(&studio->world, words);
    studio->camera = framing_first(&studio->world);
    picture_open(&studio->picture, &studio->world);
    picture_take(&studio->picture, &studio->world, &studio->camera, &mode_skin);
}

#define STUDIO(studio, ...) studio_open((studio), (const char* const[]){__VA_ARGS__, NULL})

static void studio_close(Studio* studio) {
    picture_close(&studio->picture);
    world_close(&studio->world);
}

static double dot3(const float* a, const float* b) {
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static const char* row(const Panel* panel, const char* label) {
    for (int r = 0; r < panel->row_count; r++)
        if (strcmp(panel->row[r].label, label) == 0)
            return panel->row[r].value;
    return NULL;
}

static void normals_are_unit_and_point_outward(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "cube-sphere:8");
    const PictureSkin* skin = &studio.picture.skin[0];
    for (int i = 0; i < skin->point_count; i++) {
        // single precision, one square root and one division
        assert_near(dot3(skin->normal[i], skin->normal[i]), 1, 1e-6);

        // the shape is centred on the origin; the faces around a point of a sphere of eight quads a
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
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    for (int i = 0; i < body->count; i++)
        assert_near((double)studio.picture.skin[0].stretch[i], 2, TOLERANCE(1e-5, 1e-6));
    studio_close(&studio);
}

/// The larger principal stretch of rubber, which edges alone would not tell: x is doubled, and the
/// largest is 2 wherever the skin lies along x.
static void rubber_shows_its_larger_principal_stretch(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, RUBBER("grid:5x5", ""));
    Body* body = &studio.world.balloon[0].body;
    for (int i = 0; i < body->count; i++)
        body->x[i][0] *= 2;
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_stretch);
    for (int i = 0; i < body->count; i++)
        assert_near((double)studio.picture.skin[0].field[i], 2, TOLERANCE(1e-5, 1e-6));
    studio_close(&studio);
}

/// Twice the size: rubber that keeps its volume element by element is a quarter as thick. Under
/// the global rule the thickness is a state, and holds until volume preservation changes it.
static void thickness_and_volume_ratio_follow_the_elements(void** state) {
    (void)state;
    for (int global = 0; global < 2; global++) {
        Studio studio;
        STUDIO(&studio, RUBBER("cube-sphere:4", ""),
               global ? "balloons.0.skin.membrane.volume=global" : "balloons.0.turn=10");
        Picture* picture = &studio.picture;
        const Mode* mode[] = {&mode_thickness, &mode_volume_ratio};
        const double at_rest[] = {0.3, 1};
        const double twice[2][2] = {{0.3 / 4, 1}, {0.3, 4}};
        Body* body = &studio.world.balloon[0].body;
        for (int big = 0; big < 2; big++) {
            for (int m = 0; m < 2; m++) {
                picture_take(picture, &studio.world, &studio.camera, mode[m]);
                const double want = big ? twice[global][m] : at_rest[m];
                for (int i = 0; i < body->count; i++)
                    assert_close((double)picture->skin[0].field[i], want, 2e-6); // float fields
                assert_true((double)picture->range[0] <= want * (1 + 1e-4));
                assert_true((double)picture->range[1] >= want * (1 - 1e-4));
            }
            for (int i = 0; i < body->count; i++)
                body->x[i] *= 2;
        }
        studio_close(&studio);
    }
}

/// A thin patch is darker than the rest. Its middle is the mean over elements whose own thickness
/// is the mean of their corners: a little thicker than the patch's.
static void a_thin_patch_is_shown(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio,
           RUBBER("cube-sphere:16", ", patches: [{at: [0, 1, 0], radius: 0.5, thickness: 1e-4}]"));
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_thickness);
    const PictureSkin* skin = &studio.picture.skin[0];
    assert_near((double)studio.picture.range[1], 0.3, 1e-6);
    int top = 0, bottom = 0;
    for (int i = 0; i < skin->point_count; i++) {
        top = skin->position[i][1] > skin->position[top][1] ? i : top;
        bottom = skin->position[i][1] < skin->position[bottom][1] ? i : bottom;
    }
    assert_near((double)skin->field[top], 0.1, 0.03);
    assert_near((double)skin->field[bottom], 0.3, 1e-6);
    assert_true(studio.picture.range[0] <= skin->field[top]);
    assert_less((double)skin->tint[top][1], (double)skin->tint[bottom][1]);
    studio_close(&studio);
}

/// The push that is shown is the one that the force table adds.
static void the_pressure_mode_shows_the_force_of_inflation(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "squirrel-inflates", "balloons.0.inflation={law: area, amount: 4}");
    Body* body = &studio.world.balloon[0].body;
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_pressure);
    memset(body->f, 0, (size_t)body->count * sizeof *body->f);
    force_add(&force_inflation, body);
    double most = 0;
    for (int i = 0; i < body->count; i++)
        most = fmax(most, (double)length(body->f[i]));
    for (int i = 0; i < body->count; i++)
        // products of edges of a hundredth of the positions they are the differences of, in float
        assert_near((double)studio.picture.skin[0].field[i], (double)length(body->f[i]),
                    TOLERANCE(1e-4, 1e-6) * most);
    assert_less(most, (double)studio.picture.range[1] * (1 + 1e-4));
    assert_true(studio.picture.line_count > 0);
    studio_close(&studio);
}

/// What a balloon does not have is not shown on it: it stays plain rubber, the key passes the mode
/// by, and the status box says so where the mode was asked for.
static void a_mode_of_rubber_passes_springs_by(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_thickness);
    assert_int_equal(studio.picture.skin[0].paint, PAINT_RUBBER);
    const Mode* mode = &mode_skin;
    do {
        assert_ptr_not_equal(mode, &mode_thickness);
        assert_ptr_not_equal(mode, &mode_volume_ratio);
        mode = mode_after(mode, &studio.world);
    } while (mode != &mode_skin);

    Panel panel = {0};
    const Status status = {.mode = &mode_thickness, .slow = 1, .message = ""};
    status_take(&panel, &studio.world, &studio.picture, &status);
    assert_string_equal(row(&panel, "shown"), "thickness, which nothing here has");
    studio_close(&studio);
}

static void a_scale_says_its_ends_and_unit(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, RUBBER("cube-sphere:4", ""));
    Panel panel = {0};
    const Status status = {.mode = &mode_thickness, .slow = 1, .message = ""};
    picture_take(&studio.picture, &studio.world, &studio.camera, status.mode);
    status_take(&panel, &studio.world, &studio.picture, &status);
    assert_string_equal(row(&panel, "shown"), "thickness, 0.25 to 0.3 mm");
    studio_close(&studio);
}

static void the_ends_of_a_scale_hold_what_is_between(void** state) {
    (void)state;
    for (double x = 1e-9; x < 1e9; x *= 1.0173) {
        assert_true(field_above(x) >= x * (1 - 1e-4) && field_above(x) <= 1.34 * x);
        assert_true(field_below(x) <= x * (1 + 1e-4) && field_below(x) >= x / 1.34);
        assert_near(field_above(field_above(x)), field_above(x), 1e-12 * x);
        assert_near(field_below(field_above(x)), field_above(x), 1e-12 * x);
    }
}

static double distance(const float* a, const float* b) {
    const float d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot3(d, d));
}

static void a_string_is_drawn_from_its_particle_to_its_fixed_end(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    const String* string = &studio.world.balloon[0].body.string[0];
    const Picture* picture = &studio.picture;
    const float anchor[3] = {(float)string->anchor[0], (float)string->anchor[1],
                             (float)string->anchor[2]};
    assert_int_equal(picture->line_count, ROPE_SEGMENTS);
    assert_near(distance(picture->line[0].from, picture->skin[0].position[string->particle]), 0, 0);
    assert_near(distance(picture->line[ROPE_SEGMENTS - 1].to, anchor), 0, 1e-5);
    for (int s = 1; s < ROPE_SEGMENTS; s++)
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

static bool finite3(const float* a) {
    return isfinite(a[0]) && isfinite(a[1]) && isfinite(a[2]);
}

static void every_mode_draws_finite_numbers(void** state) {
    (void)state;
    static const char* const scene[] = {"tether", "grid:6x6", "cube", "squirrel.obj", "peak"};
    for (size_t s = 0; s < sizeof scene / sizeof *scene; s++) {
        Studio studio;
        STUDIO(&studio, scene[s]);
        for (int n = 0; n < 5; n++)
            world_step(&studio.world);
        for (int m = 0; m < mode_count; m++) {
            const Picture* picture = &studio.picture;
            picture_take(&studio.picture, &studio.world, &studio.camera, mode_table[m]);
            if (mode_fits(mode_table[m], &studio.world.balloon[0]))
                assert_int_equal(picture->skin[0].paint, mode_table[m]->paint);
            for (int i = 0; i < picture->skin[0].point_count; i++)
                assert_true(finite3(picture->skin[0].tint[i]));
            for (int i = 0; i < picture->line_count; i++)
                assert_true(finite3(picture->line[i].from) && finite3(picture->line[i].to));
            for (int i = 0; i < picture->ball_count; i++)
                assert_true(finite3(picture->ball[i].center));
        }
        studio_close(&studio);
    }
}

static void a_picture_changes_no_bit_of_the_world(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    const uint64_t before = world_hash(&studio.world);
    for (int m = 0; m < mode_count; m++)
        picture_take(&studio.picture, &studio.world, &studio.camera, mode_table[m]);
    assert_true(world_hash(&studio.world) == before);
    studio_close(&studio);
}

static void the_springs_mode_draws_each_spring_that_faces_the_eye(void** state) {
    (void)state;
    Studio studio;
    // an open skin has no far side: every spring is drawn
    STUDIO(&studio, "grid:6x6", "balloons.0.strings=[]");
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_springs);
    assert_int_equal(studio.picture.line_count, studio.world.balloon[0].body.springs.count);
    studio_close(&studio);
}

/// The string key ties a string to a balloon whose scene has none: there is room to draw it.
static void a_string_tied_later_is_drawn(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "cube", "balloons.0.strings=[]");
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    const int before = studio.picture.line_count;
    balloon_tie(&studio.world.balloon[0], &studio.world.def, true);
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_skin);
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

static void throw_at(World* world, double x, double y, double z, double radius) {
    const Event event = {
        .step = world->clock, .kind = EVENT_THROW, .thrown = {x, y, z, 0, 0, 0, 1, radius}};
    Fault fault = {0};
    assert_true(world_event(world, &event, &fault));
}

static bool shows_ball(const Picture* picture, double x, double y, double z, double radius) {
    const float center[3] = {(float)x, (float)y, (float)z};
    for (int b = 0; b < picture->ball_count; b++)
        if (distance(picture->ball[b].center, center) < 1e-5 &&
            fabs((double)picture->ball[b].radius - radius) < 1e-6)
            return true;
    return false;
}

/// Those of the scene, and more and more thrown ones: in every mode.
static void every_ball_is_drawn_in_every_mode(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether", "spheres=[{position: [3, 0, 0], radius: 0.5, mass: 1}]");
    assert_true(shows_ball(&studio.picture, 3, 0, 0, 0.5));
    for (int n = 1; n <= 40; n++) {
        throw_at(&studio.world, -3, 0.3 * n, 0, 0.1);
        const Mode* mode = mode_table[n % mode_count];
        picture_take(&studio.picture, &studio.world, &studio.camera, mode);
        assert_true(shows_ball(&studio.picture, 3, 0, 0, 0.5));
        for (int k = 1; k <= n; k++)
            assert_true(shows_ball(&studio.picture, -3, 0.3 * k, 0, 0.1));
    }
    const PictureBall* room = studio.picture.ball;
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    assert_ptr_equal(studio.picture.ball, room);
    studio_close(&studio);
}

static void a_ball_widens_the_scene_unless_it_has_flown_away(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    const float before = studio.picture.scene_radius;
    throw_at(&studio.world, 1e4, 0, 0, 0.5);
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    assert_near((double)studio.picture.scene_radius, (double)before, 0);
    const Camera camera = framing_all(&studio.world);
    assert_near((double)camera.distance, (double)studio.camera.distance, 0);

    throw_at(&studio.world, 4, 0, 0, 0.5);
    picture_take(&studio.picture, &studio.world, &studio.camera, &mode_skin);
    const float center[3] = {4, 0, 0};
    assert_less((double)before, (double)studio.picture.scene_radius);
    assert_true(distance(center, studio.picture.scene_center) <=
                (double)studio.picture.scene_radius);
    assert_less((double)camera.distance, (double)framing_all(&studio.world).distance);
    studio_close(&studio);
}

static long stamp_after(Studio* studio, const Mode* mode) {
    picture_take(&studio->picture, &studio->world, &studio->camera, mode);
    return studio->picture.stamp;
}

/// The renderer hands on what has a new stamp, and nothing else.
static void a_picture_has_a_new_stamp_when_it_is_another(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    long last = studio.picture.stamp;
    assert_true(last > 0);
    assert_int_equal(stamp_after(&studio, &mode_skin), last);
    camera_orbit(&studio.camera, 0.1F, 0); // the eye is the renderer's business
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
    collide_add(&studio.world.collide, &ball);
    assert_true(stamp_after(&studio, &mode_stretch) > last);
    last = studio.picture.stamp;
    studio.world.collide.sphere[0].x[1] = 4;
    assert_true(stamp_after(&studio, &mode_stretch) > last);
    last = studio.picture.stamp;
    collide_clear(&studio.world.collide);
    assert_true(stamp_after(&studio, &mode_stretch) > last);
    studio_close(&studio);
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

static void the_scale_of_colours_grows_brighter(void** state) {
    (void)state;
    double before = -1;
    for (int k = 0; k <= 100; k++) {
        float color[3];
        color_scale((float)k / 100, color);
        // luminance of linear light, ITU-R BT.709
        const double light =
            0.2126 * (double)color[0] + 0.7152 * (double)color[1] + 0.0722 * (double)color[2];
        assert_less(before, light);
        before = light;
    }
}

static void mode_names_are_found_and_walked_round(void** state) {
    (void)state;
    Studio studio; // of springs and rubber, so that every mode fits
    STUDIO(&studio, "two-joined",
           "balloons.0.skin={springs: {structural: 1, shear: 1, flexion: 1}}",
           "balloons.0.mass={per_particle: 0.001}");
    const Mode* mode = mode_table[0];
    for (int m = 0; m < mode_count; m++) {
        assert_ptr_equal(mode_find(mode_table[m]->name), mode_table[m]);
        assert_ptr_equal(mode, mode_table[m]);
        assert_non_null(strstr(mode_names(), mode->name));
        mode = mode_after(mode, &studio.world);
    }
    assert_ptr_equal(mode, mode_table[0]);
    assert_null(mode_find("no such mode"));
    studio_close(&studio);
}

static void a_bad_state_is_said_before_any_message(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    Panel panel = {0};
    const Status status = {.mode = &mode_stretch, .slow = 4, .message = "all is well"};
    status_take(&panel, &studio.world, &studio.picture, &status);
    assert_string_equal(panel.message, "all is well");
    assert_false(panel.alarm);
    assert_true(panel.row_count > 0);

    studio.world.blowup.halted = true;
    snprintf(studio.world.blowup.text, sizeof studio.world.blowup.text, "it went bad");
    status_take(&panel, &studio.world, &studio.picture, &status);
    assert_string_equal(panel.message, "it went bad");
    assert_true(panel.alarm);
    studio_close(&studio);
}

static void balls_are_counted_and_a_pass_through_is_said(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    Panel panel = {0};
    const Hand hand = {.mass = 10, .radius = 0.2, .speed = 50};
    Status status = {.mode = &mode_skin, .hand = &hand, .slow = 1, .message = ""};
    status_take(&panel, &studio.world, &studio.picture, &status);
    assert_null(row(&panel, "balls"));
    assert_null(row(&panel, "pass-throughs"));

    throw_at(&studio.world, 3, 0, 0, 0.2);
    status_take(&panel, &studio.world, &studio.picture, &status);
    assert_string_equal(row(&panel, "balls"), "1");
    assert_string_equal(row(&panel, "next ball"), "mass 10, radius 0.2, speed 50");
    assert_string_equal(row(&panel, "pass-throughs"), "0");
    assert_false(panel.alarm);

    studio.world.collide.pass_throughs = 2;
    status_take(&panel, &studio.world, &studio.picture, &status);
    assert_string_equal(row(&panel, "pass-throughs"), "2");
    assert_true(panel.alarm);
    assert_non_null(strstr(panel.message, "pass-throughs 2"));

    // what the user has just asked for is read first
    status.message = "quads";
    status_take(&panel, &studio.world, &studio.picture, &status);
    assert_string_equal(panel.message, "quads");
    assert_false(panel.alarm);
    studio_close(&studio);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_are_unit_and_point_outward),
        cmocka_unit_test(at_rest_nothing_is_stretched),
        cmocka_unit_test(twice_the_size_is_a_stretch_of_two),
        cmocka_unit_test(rubber_shows_its_larger_principal_stretch),
        cmocka_unit_test(thickness_and_volume_ratio_follow_the_elements),
        cmocka_unit_test(a_thin_patch_is_shown),
        cmocka_unit_test(the_pressure_mode_shows_the_force_of_inflation),
        cmocka_unit_test(a_mode_of_rubber_passes_springs_by),
        cmocka_unit_test(a_scale_says_its_ends_and_unit),
        cmocka_unit_test(the_ends_of_a_scale_hold_what_is_between),
        cmocka_unit_test(a_string_is_drawn_from_its_particle_to_its_fixed_end),
        cmocka_unit_test(a_slack_string_keeps_its_length),
        cmocka_unit_test(a_slack_string_lies_on_the_floor),
        cmocka_unit_test(every_mode_draws_finite_numbers),
        cmocka_unit_test(a_picture_changes_no_bit_of_the_world),
        cmocka_unit_test(the_springs_mode_draws_each_spring_that_faces_the_eye),
        cmocka_unit_test(a_string_tied_later_is_drawn),
        cmocka_unit_test(the_scene_lies_within_its_radius),
        cmocka_unit_test(every_ball_is_drawn_in_every_mode),
        cmocka_unit_test(a_ball_widens_the_scene_unless_it_has_flown_away),
        cmocka_unit_test(a_picture_has_a_new_stamp_when_it_is_another),
        cmocka_unit_test(the_scenes_camera_stands_where_it_says),
        cmocka_unit_test(the_scale_of_colours_grows_brighter),
        cmocka_unit_test(mode_names_are_found_and_walked_round),
        cmocka_unit_test(a_bad_state_is_said_before_any_message),
        cmocka_unit_test(balls_are_counted_and_a_pass_through_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
