/// The quantities and colors of the display modes.
#include "force/force.h"
#include "studio.h"
#include "view/color.h"
#include "view/field.h"

/// The larger principal stretch of rubber, which edges alone do not give: x is doubled, and the
/// largest stretch is 2 where the skin is parallel to x.
static void rubber_shows_its_larger_principal_stretch(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, RUBBER("grid:5x5", ""));
    Body* body = &studio.world.balloon[0].body;
    for (int i = 0; i < body->count; i++)
        body->x[i][0] *= 2;
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_stretch);
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
                picture_update(picture, &studio.world, &studio.camera, mode[m]);
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
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_thickness);
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

/// The displayed pressure force is the one that the force table adds.
static void the_pressure_mode_shows_the_force_of_inflation(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "squirrel-inflates", "balloons.0.inflation={law: area, amount: 4}");
    Body* body = &studio.world.balloon[0].body;
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_pressure);
    memset(body->f, 0, (size_t)body->count * sizeof *body->f);
    force_add(&force_inflation, body);
    double max = 0;
    for (int i = 0; i < body->count; i++)
        max = fmax(max, (double)length(body->f[i]));
    for (int i = 0; i < body->count; i++)
        // products of edges of a hundredth of the positions they are the differences of, in float
        assert_near((double)studio.picture.skin[0].field[i], (double)length(body->f[i]),
                    TOLERANCE(1e-4, 1e-6) * max);
    assert_less(max, (double)studio.picture.range[1] * (1 + 1e-4));
    assert_true(studio.picture.line_count > 0);
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
            picture_update(&studio.picture, &studio.world, &studio.camera, mode_table[m]);
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

static void the_springs_mode_draws_each_spring_that_faces_the_eye(void** state) {
    (void)state;
    Studio studio;
    // an open skin has no far side: every spring is drawn
    STUDIO(&studio, "grid:6x6", "balloons.0.strings=[]");
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_springs);
    assert_int_equal(studio.picture.line_count, studio.world.balloon[0].body.springs.count);
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

static void the_scale_of_colors_grows_brighter(void** state) {
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rubber_shows_its_larger_principal_stretch),
        cmocka_unit_test(thickness_and_volume_ratio_follow_the_elements),
        cmocka_unit_test(a_thin_patch_is_shown),
        cmocka_unit_test(the_pressure_mode_shows_the_force_of_inflation),
        cmocka_unit_test(every_mode_draws_finite_numbers),
        cmocka_unit_test(the_springs_mode_draws_each_spring_that_faces_the_eye),
        cmocka_unit_test(the_ends_of_a_scale_hold_what_is_between),
        cmocka_unit_test(the_scale_of_colors_grows_brighter),
        cmocka_unit_test(mode_names_are_found_and_walked_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
