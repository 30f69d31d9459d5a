/// The shadow on the floor, and the order of translucent surfaces.
#include "draw/depth.h"
#include "draw/shadow.h"
#include "drawn.h"

// The share of light that reaches the floor at (x, 0).
static double light_at(const Shadow* shadow, double x) {
    const double reach = (double)shadow_reach(&drawn.picture);
    const int column = (int)((x / reach + 1) * SHADOW_CELLS / 2 + 0.5);
    return shadow->light[SHADOW_CELLS / 2 * SHADOW_SIDE + column][1] / 255.0;
}

static void a_shadow_is_dark_below_and_gone_far_away(void** state) {
    (void)state;
    Shadow shadow = shadow_open();
    drawn.picture.floor_height = 0.9f;
    shadow_cast(&shadow, &drawn.picture);
    assert_less(light_at(&shadow, 0.2), 0.45);
    assert_less(0.97, light_at(&shadow, -4));
    shadow_close(&shadow);
}

static void a_higher_balloon_casts_a_fainter_shadow(void** state) {
    (void)state;
    Shadow shadow = shadow_open();
    double last = 0;
    for (int i = 0; i < 4; i++) {
        blow_up(1, 1.1f + (float)i);
        shadow_cast(&shadow, &drawn.picture);
        double darkest = 1;
        for (int k = 0; k < SHADOW_SIDE * SHADOW_SIDE; k++)
            darkest = fmin(darkest, shadow.light[k][1] / 255.0);
        assert_less(last, darkest);
        last = darkest;
    }
    shadow_close(&shadow);
}

static void the_floor_under_a_balloon_is_darker(void** state) {
    (void)state;
    drawn.picture.floor_height = 0.9f;
    draw(pixels);
    drawn.picture.skin_count = 0;
    draw(others);
    // just below the balloon's outline, right of its middle, in the key light's shadow
    assert_less(brightness(pixels[88][WIDTH / 2 + 8]), brightness(others[88][WIDTH / 2 + 8]) - 60);
}

static void depth_sort_is_far_to_near_and_stable(void** state) {
    (void)state;
    enum { COUNT = 1000 };
    static float depth[COUNT];
    static int order[COUNT];
    static uint64_t scratch[2 * COUNT];
    for (int i = 0; i < COUNT; i++)
        depth[i] = (float)(i * 7919 % 250);
    depth_sort(depth, COUNT, order, scratch);
    for (int i = 1; i < COUNT; i++) {
        const float before = depth[order[i - 1]], here = depth[order[i]];
        assert_true(before > here || (before == here && order[i - 1] < order[i]));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_shadow_is_dark_below_and_gone_far_away, set_up),
        cmocka_unit_test_setup(a_higher_balloon_casts_a_fainter_shadow, set_up),
        cmocka_unit_test_setup(the_floor_under_a_balloon_is_darker, set_up),
        cmocka_unit_test(depth_sort_is_far_to_near_and_stable),
    };
    return cmocka_run_group_tests(tests, open_all, close_all);
}
