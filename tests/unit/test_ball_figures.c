/// What the figures of the mass-spring paper show of balls on a pillow.
#include "worlds.h"

/// How far the first ball of a scene rises above its first place within some seconds.
static double rise(const char* scene, const char* sphere, const char* contact) {
    World world;
    WORLD_OF(&world, scene, sphere, contact);
    const double start = probe(&world, "sphere0.y");
    double top = start;
    const long steps = lround(4 / world.step);
    for (long n = 0; n < steps; n++) {
        world_step(&world);
        top = fmax(top, (double)world.contacts.sphere[0].x[1]);
    }
    assert_false(world.blowup.halted);
    assert_int_equal(world.contacts.pass_throughs, 0);
    world_close(&world);
    return top - start;
}

static const double pillow_height = 1.85; // blown up to 10

/// Figures 16 to 18, by the paper's penalty: a ball of mass 1 flies several pillow heights up, one of
/// 100 less, one of 1000 barely. Rounding does not decide: a ball that starts 1e-5 farther does the same.
static void heavier_balls_are_launched_less_high(void** state) {
    (void)state;
    const char* scenes[] = {"launch-1", "launch-100", "launch-1000"};
    double height[3];
    for (int k = 0; k < 3; k++) {
        height[k] = rise(scenes[k], "contact=paper", "contact=paper") / pillow_height;
        const double moved = rise(scenes[k], "spheres.0.position=[0, 0.22001, 0]", "contact=paper");
        assert_near(moved / pillow_height, height[k], 0.02 * height[k]);
    }
    assert_less(3, height[0]);
    assert_less(height[1], 0.7 * height[0]);
    assert_less(1.5, height[1]);
    assert_less(height[2], 0.3);
    assert_less(0.05, height[2]);
}

/// The same by impulses, which keep momentum: masses count against the pillow's own.
static void heavier_balls_are_launched_less_high_by_impulses(void** state) {
    (void)state;
    const double skin = 0.794; // the pillow's particles of 1 g
    double height[3];
    for (int k = 0; k < 3; k++) {
        char sphere[128];
        snprintf(sphere, sizeof sphere, "spheres.0.mass=%g", skin * pow(10, k - 1));
        height[k] = rise("launch-1", sphere, "contact=impulse") / pillow_height;
    }
    assert_less(3, height[0]);
    assert_less(height[1], 0.5 * height[0]);
    assert_less(height[2], 0.3 * height[1]);
}

/// Figures 22 and 23: each ball goes down into the pillow and then up again by more than its diameter.
static void four_balls_bounce_off_a_pillow(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "pillow-spheres");
    double low[4], high[4] = {0};
    for (int s = 0; s < 4; s++)
        low[s] = INFINITY;
    const long steps = lround(1.6 / world.step);
    for (long n = 0; n < steps; n++) {
        world_step(&world);
        for (int s = 0; s < 4; s++) {
            const double y = (double)world.contacts.sphere[s].x[1];
            high[s] = y < low[s] ? y : fmax(high[s], y); // since the deepest point
            low[s] = fmin(low[s], y);
        }
    }
    for (int s = 0; s < 4; s++)
        assert_less(low[s] + 4 * (double)world.contacts.sphere[s].radius, high[s]);
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heavier_balls_are_launched_less_high),
        cmocka_unit_test(heavier_balls_are_launched_less_high_by_impulses),
        cmocka_unit_test(four_balls_bounce_off_a_pillow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
