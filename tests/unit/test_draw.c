// Pictures drawn without a window: positions and occlusion, and that a picture does not depend on
// earlier ones.
#include "drawn.h"

static bool is_red(const unsigned char rgb[3]) {
    return rgb[0] > 1.6 * rgb[1] && rgb[0] > 1.6 * rgb[2];
}

static bool is_blue(const unsigned char rgb[3]) {
    return rgb[2] > 1.6 * rgb[0] && rgb[2] > 1.6 * rgb[1];
}

static int red_pixels(void) {
    int count = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            count += is_red(pixels[y][x]);
    return count;
}

static void a_balloon_is_in_the_middle_of_a_pale_studio(void** state) {
    (void)state;
    draw(pixels);
    assert_true(is_red(pixels[HEIGHT / 2][WIDTH / 2]));
    const unsigned char* corner[] = {pixels[0][0], pixels[0][WIDTH - 1], pixels[HEIGHT - 1][0],
                                     pixels[HEIGHT - 1][WIDTH - 1]};
    for (int i = 0; i < 4; i++) {
        assert_false(is_red(corner[i]));
        assert_less(450, brightness(corner[i]));
    }
}

static void a_balloon_covers_what_its_radius_says(void** state) {
    (void)state;
    // seen from far away a sphere is a disc of half-angle asin(r/d)
    for (int i = 1; i <= 3; i++) {
        const float radius = 0.4f * (float)i;
        blow_up(radius, 2);
        draw(pixels);
        const double pixel = 2 * tan(0.3) / HEIGHT, slope = tan(asin(radius / 9));
        // its highlight and its translucent rim are not red
        assert_close(red_pixels(), PI * pow(slope / pixel, 2), 0.15);
    }
}

static void same_bytes(void) {
    assert_memory_equal(pixels, others, sizeof pixels);
}

static void other_bytes(void) {
    assert_memory_not_equal(pixels, others, sizeof pixels);
}

/// Uploads skipped because of an equal stamp change no pixel: view from elsewhere and back, and
/// with another stamp.
static void a_stamp_changes_nothing_of_what_is_drawn(void** state) {
    (void)state;
    draw(others);
    drawn.picture.stamp = 1;
    const float turns[] = {0, 0, 0.5f, 0};
    for (int k = 0; k < 4; k++) {
        drawn.picture.camera.yaw = turns[k];
        draw(pixels);
        (turns[k] == 0 ? same_bytes : other_bytes)();
    }
    blow_up(0.3f, 1);
    drawn.picture.stamp = 2;
    draw(pixels);
    other_bytes();
}

static void the_same_picture_gives_the_same_bytes(void** state) {
    (void)state;
    draw(pixels);
    blow_up(0.3f, 1);
    draw(others);
    assert_memory_not_equal(pixels, others, sizeof pixels);
    blow_up(1, 2);
    draw(others);
    assert_memory_equal(pixels, others, sizeof pixels);
}

static void a_size_drawn_before_another_leaves_no_trace(void** state) {
    (void)state;
    draw(pixels);
    renderer_resize(renderer, 37, 211);
    renderer_draw(renderer, &drawn.picture);
    renderer_resize(renderer, WIDTH, HEIGHT);
    draw(others);
    assert_memory_equal(pixels, others, sizeof pixels);
}

static void stretched_rubber_is_paler(void** state) {
    (void)state;
    draw(pixels);
    const unsigned char* middle = pixels[HEIGHT / 2][WIDTH / 2];
    int last = middle[1] + middle[2];
    for (int s = 2; s <= 4; s++) {
        for (int i = 0; i < POINTS; i++)
            drawn.stretch[i] = (float)s;
        draw(pixels);
        assert_less(last, middle[1] + middle[2]);
        last = middle[1] + middle[2];
    }
}

static void a_ball_behind_shows_only_through_stretched_rubber(void** state) {
    (void)state;
    const unsigned char* middle = pixels[HEIGHT / 2][WIDTH / 2];
    int change[2];
    for (int thin = 0; thin < 2; thin++) {
        for (int i = 0; i < POINTS; i++)
            drawn.stretch[i] = thin ? 3 : 1;
        drawn.picture.ball_count = 0;
        draw(pixels);
        const int without = brightness(middle);
        drawn.ball[0] = (PictureBall){.center = {0, 2, 0}, .radius = 0.5f};
        drawn.picture.ball_count = 1;
        draw(pixels);
        change[thin] = without - brightness(middle);
    }
    assert_less(change[0], 20);
    assert_less(60, change[1]);
}

static void a_field_is_drawn_in_its_own_colors(void** state) {
    (void)state;
    drawn.skin.paint = PAINT_FIELD;
    draw(pixels);
    assert_true(is_blue(pixels[HEIGHT / 2][WIDTH / 2]));
}

static void a_line_on_the_skin_is_seen_in_front_and_not_behind(void** state) {
    (void)state;
    drawn.skin.paint = PAINT_FIELD;
    drawn.picture.camera.pitch = 0;
    for (int side = -1; side <= 1; side += 2) {
        const float z = (float)side;
        drawn.line[0] = (PictureLine){
            .from = {-0.3f, 2, z}, .to = {0.3f, 2, z}, .color = {1, 0, 0}, .width = 24};
        drawn.picture.line_count = 1;
        draw(pixels);
        assert_int_equal(is_red(pixels[HEIGHT / 2][WIDTH / 2]), side == 1);
    }
}

static void a_faint_shape_veils_a_line_within_and_hides_none(void** state) {
    (void)state;
    drawn.skin.paint = PAINT_FAINT;
    drawn.picture.camera.pitch = 0;
    drawn.line[0] =
        (PictureLine){.from = {-0.3f, 2, 0}, .to = {0.3f, 2, 0}, .color = {0, 0, 1}, .width = 24};
    const unsigned char* middle = pixels[HEIGHT / 2][WIDTH / 2];
    draw(pixels);
    const int without = middle[0];
    drawn.picture.line_count = 1;
    draw(pixels);
    const int within = middle[0];
    assert_less(within, without - 40);

    // in front of the shape the same line is drawn in full
    drawn.line[0].from[2] = drawn.line[0].to[2] = 1.1f;
    draw(pixels);
    assert_less(middle[0], within - 40);
    assert_true(is_blue(middle));
}

static void what_is_selected_glows_around_and_nowhere_else(void** state) {
    (void)state;
    draw(pixels);
    drawn.skin.selected = true;
    draw(others);

    // the balloon's radius in pixels is 0.112 / 0.0052 = 21
    const int middle = HEIGHT / 2;
    assert_memory_equal(pixels[middle][WIDTH / 2], others[middle][WIDTH / 2], 3);
    assert_memory_equal(pixels[middle][0], others[middle][0], 3);
    assert_memory_not_equal(pixels[middle][WIDTH / 2 + 24], others[middle][WIDTH / 2 + 24], 3);
}

static void an_open_skin_shows_its_inside(void** state) {
    (void)state;
    // the rear half alone, seen from inside
    int count = 0;
    for (int i = 0; i < TRIANGLES; i++)
        if (drawn.position[drawn.triangle[i][0]][2] < -0.1f)
            memcpy(drawn.triangle[count++], drawn.triangle[i], sizeof drawn.triangle[0]);
    drawn.skin.triangle_count = count;
    drawn.skin.paint = PAINT_FIELD;
    draw(pixels);
    assert_false(is_blue(pixels[HEIGHT / 2][WIDTH / 2]));
    drawn.skin.two_sided = true;
    draw(pixels);
    assert_true(is_blue(pixels[HEIGHT / 2][WIDTH / 2]));
}

static void an_empty_picture_is_an_empty_studio(void** state) {
    (void)state;
    drawn.picture.skin_count = 0;
    draw(pixels);
    assert_int_equal(red_pixels(), 0);
    drawn.picture.floor = false;
    draw(others);
    assert_memory_equal(pixels[0][0], others[0][0], 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_balloon_is_in_the_middle_of_a_pale_studio, set_up),
        cmocka_unit_test_setup(a_balloon_covers_what_its_radius_says, set_up),
        cmocka_unit_test_setup(a_stamp_changes_nothing_of_what_is_drawn, set_up),
        cmocka_unit_test_setup(the_same_picture_gives_the_same_bytes, set_up),
        cmocka_unit_test_setup(a_size_drawn_before_another_leaves_no_trace, set_up),
        cmocka_unit_test_setup(stretched_rubber_is_paler, set_up),
        cmocka_unit_test_setup(a_ball_behind_shows_only_through_stretched_rubber, set_up),
        cmocka_unit_test_setup(a_field_is_drawn_in_its_own_colors, set_up),
        cmocka_unit_test_setup(a_line_on_the_skin_is_seen_in_front_and_not_behind, set_up),
        cmocka_unit_test_setup(a_faint_shape_veils_a_line_within_and_hides_none, set_up),
        cmocka_unit_test_setup(what_is_selected_glows_around_and_nowhere_else, set_up),
        cmocka_unit_test_setup(an_open_skin_shows_its_inside, set_up),
        cmocka_unit_test_setup(an_empty_picture_is_an_empty_studio, set_up),
    };
    return cmocka_run_group_tests(tests, open_all, close_all);
}
