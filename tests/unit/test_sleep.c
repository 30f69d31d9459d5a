/// Balloons at rest sleep without cost, and wake when anything acts on them.
#include "worlds.h"

static const double settle = 20; ///< [s]

static void open_tether(World* world, const char* rest) {
    WORLD_OF(world, "tether", rest);
}

/// Sleep skips the remaining motion: 5 s at a thousandth of its size a second, because
/// the string's swing decays at 10/s.
static void a_balloon_at_rest_sleeps_where_it_would_be(void** state) {
    (void)state;
    World world[2];
    open_tether(&world[0], "sleep_threshold=0");
    open_tether(&world[1], "sleep_threshold=1e-3");
    for (int k = 0; k < 2; k++)
        run_for(&world[k], settle);
    const Body *awake = &world[0].balloon[0].body, *asleep = &world[1].balloon[0].body;
    assert_false(awake->asleep);
    assert_true(asleep->asleep);
    for (int i = 0; i < asleep->count; i++) {
        assert_near((double)length(asleep->x[i] - awake->x[i]), 0, 1e-3 * asleep->size);
        assert_near((double)length(asleep->v[i]), 0, 0);
    }
    const uint64_t hash = world_hash(&world[1]);
    run_for(&world[1], 1);
    assert_true(world_hash(&world[1]) == hash);
    for (int k = 0; k < 2; k++)
        world_close(&world[k]);
}

static void a_key_wakes_it(void** state) {
    (void)state;
    World world;
    open_tether(&world, "sleep_threshold=1e-3");
    run_for(&world, settle);
    assert_true(world.balloon[0].body.asleep);
    const double volume = probe(&world, "balloon0.volume");
    press(&world, "inflate", "down");
    run_for(&world, 2);
    assert_false(world.balloon[0].body.asleep);
    assert_less(1.01 * volume, probe(&world, "balloon0.volume"));
    world_close(&world);
}

/// A filling that begins while it sleeps.
static void gas_wakes_it(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "tether", "sleep_threshold=1e-3",
             "balloons.0.inflation.fill={to: 5, start: 21, seconds: 1}");
    run_for(&world, 20);
    assert_true(world.balloon[0].body.asleep);
    const double volume = probe(&world, "balloon0.volume");
    run_for(&world, 2);
    assert_false(world.balloon[0].body.asleep);
    assert_less(1.01 * volume, probe(&world, "balloon0.volume"));
    world_close(&world);
}

/// A ball that flies for 2.9 s does not wake the balloon before it arrives. It then
/// does not pass through, and the balloon gains the momentum that the ball loses.
static void a_ball_wakes_it(void** state) {
    (void)state;
    World world;
    open_tether(&world, "sleep_threshold=1e-3");
    run_for(&world, settle);
    Event event = {.kind = EVENT_THROW, .step = world.clock};
    const double y = probe(&world, "balloon0.cy");
    const double thrown[] = {-30, y, 0, 10, 14, 0, 0.1, 0.3};
    memcpy(event.thrown, thrown, sizeof thrown);
    Fault fault = {0};
    assert_true(world_event(&world, &event, &fault)); // an event wakes it for a moment
    run_for(&world, 1);
    assert_true(world.balloon[0].body.asleep);
    while (world.balloon[0].body.asleep && world_time(&world) < settle + 5)
        world_step(&world);
    assert_less(-4, (double)world.contacts.sphere[0].x[0]);
    assert_less((double)world.contacts.sphere[0].x[0], -1);
    run_for(&world, 0.3);
    assert_less((double)world.contacts.sphere[0].v[0], 9);
    assert_less(0.01, probe(&world, "balloon0.cx"));
    assert_int_equal(world.contacts.pass_throughs, 0);
    world_close(&world);
}

static int count_asleep(const World* world) {
    int count = 0;
    for (int b = 0; b < world->balloon_count; b++)
        count += world->balloon[b].body.asleep;
    return count;
}

/// Two balloons that touch fall asleep at the same step; a third one falls onto them, they wake, and
/// then all three sleep at the same step where they touch.
static void balloons_that_touch_sleep_together_and_wake_by_touch(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "heap", "sleep_threshold=0.02", "balloons.0.model=icosphere:1",
             "balloons.1.model=icosphere:1", "balloons.2.model=icosphere:1",
             "walls.0.at=[-0.097, 0, 0]", "walls.1.at=[0.297, 0, 0]",
             "balloons.1.position=[0.2005, 0.11, 0]", "balloons.2.position=[0.1, 15, 0.01]");
    bool together = false, woken = false, all = false;
    for (int n = 0; n < 14000 && !all; n++) {
        const int before = count_asleep(&world);
        world_step(&world);
        const int after = count_asleep(&world);
        if (probe(&world, "balloon2.cy") > 1) {
            assert_true(after == before || (before == 0 && after == 2));
            together |= after == 2;
        }
        woken |= together && after == 0;
        assert_true(!woken || after == 0 || after == 3);
        all = woken && after == 3;
    }
    assert_true(together);
    assert_true(woken);
    assert_true(all);
    const uint64_t hash = world_hash(&world);
    run_for(&world, 1);
    assert_true(world_hash(&world) == hash);
    assert_near(probe(&world, "crossings"), 0, 0);
    assert_less(0.2, probe(&world, "balloon2.cy")); // it lies on the two
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_balloon_at_rest_sleeps_where_it_would_be),
        cmocka_unit_test(a_key_wakes_it),
        cmocka_unit_test(gas_wakes_it),
        cmocka_unit_test(a_ball_wakes_it),
        cmocka_unit_test(balloons_that_touch_sleep_together_and_wake_by_touch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
