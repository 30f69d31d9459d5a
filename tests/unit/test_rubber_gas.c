/// Gas in balloons of rubber: pipes, valves, leaks, and the lift of helium.
#include "standard.h"
#include "worlds.h"

/// The gas that leaves one balloon arrives in the other, and the small one empties into the big
/// one.
static void the_small_balloon_empties_into_the_big_one(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "two-joined");
    const double small = world.balloon[0].body.inflation.first_volume;
    const double big = world.balloon[1].body.inflation.first_volume;
    const double before = 4 * small + 4 * big;
    run_for(&world, 2);
    const double first = probe(&world, "balloon0.amount");
    assert_near(first, 4.0, 1e-9);
    run_for(&world, 6);
    const double after =
        probe(&world, "balloon0.amount") * small + probe(&world, "balloon1.amount") * big;
    assert_less(small, big);
    assert_close(after, before, 1e-12);
    assert_less(probe(&world, "balloon0.amount"), 0.7 * first);
    world_close(&world);
}

/// The flow through valve and leak is proportional to the gauge pressure, and stops at ambient
/// pressure.
static void gas_is_let_out_until_ambient(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, standard, "step=0.01", "balloons.0.damping.rate=200",
             "balloons.0.inflation={law: gas, amount: 1.5, vent: 0.01, rate: 1}");
    run_for(&world, 0.5);
    press(&world, "deflate", "down");
    run_for(&world, 3);
    assert_near(probe(&world, "balloon0.gauge_pressure"), 0, 60);
    assert_near(probe(&world, "balloon0.amount"), 1, 0.02);
    assert_less(0.999, probe(&world, "balloon0.amount"));
    world_close(&world);

    WORLD_OF(&world, standard, "step=0.01", "balloons.0.damping.rate=200",
             "balloons.0.inflation={law: gas, amount: 1.5, leak: 1e-4}");
    run_for(&world, 0.1);
    const double before = probe(&world, "balloon0.amount");
    const double pressure = probe(&world, "balloon0.gauge_pressure");
    assert_less(0, pressure);
    run_for(&world, 0.01);
    assert_close(before - probe(&world, "balloon0.amount"), 1e-4 * pressure * 0.01, 1e-3);
    world_close(&world);
}

/// The helium balloon sinks below l = 2.0555 and rises above it.
static void helium_lifts_off_when_filled_enough(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "lift-off");
    const double weight = 9.81 * 4 * PI * 0.01 * 3e-4 * 1000;
    bool light = false;
    while (world_time(&world) < 6) {
        run_for(&world, 0.1);
        const double l = cbrt(probe(&world, "balloon0.volume") / (4.18879 * 1e-3));
        const double lift = probe(&world, "balloon0.lift");
        if (l < 2.03) // the mesh is a little smaller than its sphere
            assert_less(lift, weight);
        if (l > 2.08)
            assert_less(weight, lift);
        if (!light)
            assert_less(probe(&world, "balloon0.py"), 0);
        light = light || lift > weight;
    }
    assert_true(light);
    assert_less(0, probe(&world, "balloon0.py"));
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_small_balloon_empties_into_the_big_one),
        cmocka_unit_test(gas_is_let_out_until_ambient),
        cmocka_unit_test(helium_lifts_off_when_filled_enough),
    };
    return cmocka_run_group_tests(tests, write_standard, remove_standard);
}
