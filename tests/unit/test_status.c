/// The text of the status box.
#include "studio.h"
#include "view/status.h"

static const char* row(const Overlay* overlay, const char* label) {
    for (int r = 0; r < overlay->row_count; r++)
        if (strcmp(overlay->row[r].label, label) == 0)
            return overlay->row[r].value;
    return NULL;
}

/// A mode whose quantity no balloon has is not shown: balloons stay plain, the key skips the mode,
/// and the status box says so if the mode was requested.
static void a_mode_of_rubber_passes_springs_by(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    picture_update(&studio.picture, &studio.world, &studio.camera, &mode_thickness);
    assert_int_equal(studio.picture.skin[0].paint, PAINT_RUBBER);
    const Mode* mode = &mode_skin;
    do {
        assert_ptr_not_equal(mode, &mode_thickness);
        assert_ptr_not_equal(mode, &mode_volume_ratio);
        mode = mode_after(mode, &studio.world);
    } while (mode != &mode_skin);

    Overlay overlay = {0};
    const Status status = {.mode = &mode_thickness, .slowdown = 1, .message = ""};
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_string_equal(row(&overlay, "mode"), "thickness, which no balloon here has");
    studio_close(&studio);
}

static void a_scale_says_its_ends_and_unit(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, RUBBER("cube-sphere:4", ""));
    Overlay overlay = {0};
    const Status status = {.mode = &mode_thickness, .slowdown = 1, .message = ""};
    picture_update(&studio.picture, &studio.world, &studio.camera, status.mode);
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_string_equal(row(&overlay, "mode"), "thickness, 0.25 to 0.3 mm");
    studio_close(&studio);
}

static void a_bad_state_is_said_before_any_message(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    Overlay overlay = {0};
    const Status status = {.mode = &mode_stretch, .slowdown = 4, .message = "all is well"};
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_string_equal(overlay.message, "all is well");
    assert_false(overlay.alarm);
    assert_true(overlay.row_count > 0);

    studio.world.blowup.halted = true;
    snprintf(studio.world.blowup.text, sizeof studio.world.blowup.text, "it went bad");
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_string_equal(overlay.message, "it went bad");
    assert_true(overlay.alarm);
    studio_close(&studio);
}

static void balls_are_counted_and_a_pass_through_is_said(void** state) {
    (void)state;
    Studio studio;
    STUDIO(&studio, "tether");
    Overlay overlay = {0};
    const Thrower thrower = {.mass = 10, .radius = 0.2, .speed = 50};
    Status status = {.mode = &mode_skin, .thrower = &thrower, .slowdown = 1, .message = ""};
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_null(row(&overlay, "balls"));
    assert_null(row(&overlay, "pass-throughs"));

    throw_at(&studio.world, 3, 0, 0, 0.2);
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_string_equal(row(&overlay, "balls"), "1");
    assert_string_equal(row(&overlay, "next ball"), "mass 10, radius 0.2, speed 50");
    assert_string_equal(row(&overlay, "pass-throughs"), "0");
    assert_false(overlay.alarm);

    studio.world.contacts.pass_throughs = 2;
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_string_equal(row(&overlay, "pass-throughs"), "2");
    assert_true(overlay.alarm);
    assert_non_null(strstr(overlay.message, "pass-throughs 2"));

    // the answer to a user's request is the first line
    status.message = "quads";
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_string_equal(overlay.message, "quads");
    assert_false(overlay.alarm);
    studio_close(&studio);
}

/// They are counted a few times a second, and at the first frame.
static void crossings_are_counted_where_skins_touch(void** state) {
    (void)state;
    Studio studio;
    Overlay overlay = {0};
    const Status status = {.mode = &mode_skin, .slowdown = 1, .message = ""};
    STUDIO(&studio, "tether");
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_null(row(&overlay, "crossings"));
    studio_close(&studio);

    overlay = (Overlay){0};
    STUDIO(&studio, "heap", "balloons.1.position=[0.15, 0.117, 0.011]");
    assert_non_null(
        strstr(studio.world.notice, "balloons.0 (icosphere:2) crosses balloons.1 (icosphere:2)"));
    status_fill(&overlay, &studio.world, &studio.picture, &status);
    assert_true(atoi(row(&overlay, "crossings")) > 10);
    for (int i = 0; i < studio.world.balloon[1].body.count; i++)
        studio.world.balloon[1].body.x[i][1] += 3;
    for (int k = 0; k < 2; k++) {
        status_fill(&overlay, &studio.world, &studio.picture, &status);
        assert_true((atoi(row(&overlay, "crossings")) == 0) == (k == 1));
        studio.world.clock += 1000;
    }
    studio_close(&studio);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mode_of_rubber_passes_springs_by),
        cmocka_unit_test(a_scale_says_its_ends_and_unit),
        cmocka_unit_test(a_bad_state_is_said_before_any_message),
        cmocka_unit_test(balls_are_counted_and_a_pass_through_is_said),
        cmocka_unit_test(crossings_are_counted_where_skins_touch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
