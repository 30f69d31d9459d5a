/// Things: skins and balls rest on them and are pushed by them, and nothing crosses them.
#include <string.h>

#include "crossings.h"

#define BALLOON(y)                                                                                 \
    "balloons:\n  - model: icosphere:2\n    size: 0.2\n    position: [0, " y ", 0.01]\n"           \
    "    skin: {springs: {structural: 60, shear: 20, flexion: 10}}\n"                              \
    "    mass: {per_particle: 0.0001}\n    inflation: {law: gas, amount: 1.02}\n"                  \
    "    damping: {rate: 20}\n"
#define BOX "things: [{model: box, size: [0.6, 0.2, 0.6], position: [0, -0.1, 0]}]\n"

static int crossings_with_things(const World* world) {
    int count = 0;
    for (int b = 0; b < world->balloon_count; b++)
        for (int k = 0; k < world->thing_count; k++)
            count += exact_crossings(&world->balloon[b].body, &world->thing[k].body);
    return count;
}

/// A balloon at rest presses on the box with its weight, and does so asleep, too; it lies as high as on
/// a floor, but for half of its skin's rest gap.
static void balloon_at_rest_presses_with_its_weight(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, "step: 1e-3\nsleep_threshold: 0.01\n" BOX BALLOON("0.105"));
    run_for(&world, 2);
    assert_close(probe(&world, "thing0.fy"), -balloon_weight(&world), 1e-3);
    assert_near(probe(&world, "thing0.fx"), 0, 1e-3 * balloon_weight(&world));
    run_for(&world, 1);
    assert_true(world.balloon[0].body.asleep);
    assert_close(probe(&world, "thing0.fy"), -balloon_weight(&world), 1e-3);
    const double height = probe(&world, "balloon0.cy");
    assert_near(probe(&world, "crossings"), 0, 0);
    const double gap = world.contacts.skin_pairs.skin[0].rest_gap / 2;
    world_close(&world);
    OPEN_TEXT(&world, "step: 1e-3\nfloor: 0\n" BALLOON("0.105"));
    run_for(&world, 2);
    assert_near(height - gap, probe(&world, "balloon0.cy"), 2e-4 * 0.2);
    world_close(&world);
}

/// A pyramid with a sharp top, and the edge of a box, by every method.
static void skins_never_cross_edges_and_spikes(void** state) {
    (void)state;
    static const char* const spike =
        "v 0 0.15 0\nv -0.2 -0.1 -0.2\nv 0.2 -0.1 -0.2\nv 0.2 -0.1 0.2\n"
        "v -0.2 -0.1 0.2\nf 1 3 2\nf 1 4 3\nf 1 5 4\nf 1 2 5\nf 2 3 4 5\n";
    const char* const method[] = {"method=euler", "method=newton", "method=xpbd",
                                  "method=projective"};
    char obj[64], things[160];
    snprintf(obj, sizeof obj, "%s", file_of(spike, ".obj"));
    for (int m = 0; m < 8; m++) {
        World world;
        snprintf(
            things, sizeof things, "things=[{model: %s, position: [0, %s}]", m % 2 ? obj : "box",
            m % 2 ? "-0.17, 0.03]" : "-0.22, 0.03], size: [0.3, 0.3, 0.3], rotation: [0, 20, 45]");
        OPEN_TEXT(&world, "step: 1e-3\n" BALLOON("0.105"), things, method[m / 2]);
        int touched = 0;
        for (int n = 0; n < 5; n++) {
            run_for(&world, 0.1);
            assert_false(world.blowup.halted);
            assert_int_equal(crossings_with_things(&world), 0);
            touched += world.contacts.contact_count;
        }
        assert_true(touched > 0);
        world_close(&world);
    }
    remove(obj);
}

/// A box on a path comes from below and throws a balloon up. What the balloon's momentum gains in a
/// step is the impulse of the box, to the tolerance of newton's solve, and the box comes to the end of its path.
static void momentum_of_a_pushed_balloon_is_the_things_impulse(void** state) {
    (void)state;
    const char* const method[] = {"method=euler", "method=newton", "method=xpbd"};
    for (int m = 0; m < 3; m++) {
        World world;
        OPEN_TEXT(&world, "step: 1e-3\ngravity: 0\n" BALLOON("0.105"), "balloons.0.damping=~",
                  "things=[{model: box, size: [0.4, 0.2, 0.4], rotation: [0, 0, 10], path: "
                  "[{position: [0.02, "
                  "-0.2, 0]}, {at: 0.1, position: [0, 0, 0]}, {at: 0.2, position: [0, 0, 0]}]}]",
                  "solver.tolerance=1e-7", method[m]);
        double before[3] = {0}, force = 0;
        for (int n = 0; n < 200; n++) {
            world_step(&world);
            const char* const column[2][3] = {{"balloon0.px", "balloon0.py", "balloon0.pz"},
                                              {"thing0.fx", "thing0.fy", "thing0.fz"}};
            for (int k = 0; k < 3; k++) {
                const double now = probe(&world, column[0][k]), f = probe(&world, column[1][k]);
                assert_near(now - before[k], -f * world.step,
                            TOLERANCE(1e-6, m == 1 ? 2e-7 : 1e-13));
                before[k] = now;
                force = fmax(force, fabs(f));
            }
        }
        assert_int_equal(crossings_with_things(&world), 0);
        assert_less(1, force);
        assert_less(162e-4 * 1, before[1]); // 162 particles, thrown up at more than 1 m/s
        const Thing* thing = &world.thing[0];
        for (int i = 0; i < thing->body.count; i++)
            assert_near(dlength(to_double4(thing->body.x[i] - thing->start[i]) -
                                (double4){-0.02, 0.2, 0, 0}),
                        0, 1e-5);
        world_close(&world);
    }
}

/// A box that would press a balloon to nothing on another box is held up; nothing crosses.
static void a_thing_that_would_press_a_skin_to_nothing_is_held_up(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, "step: 1e-3\n" BALLOON("0.105"),
              "things=[{model: box, size: [0.6, 0.2, 0.6], position: [0, -0.1, 0]}, {model: box, "
              "size: [0.6, "
              "0.2, 0.6], path: [{position: [0, 0.32, 0]}, {at: 0.2, position: [0, 0.1, 0]}]}]",
              "balloons.0.inflation=~");
    for (int n = 0; n < 6; n++) {
        run_for(&world, 0.05);
        assert_int_equal(crossings_with_things(&world), 0);
    }
    assert_true(world.thing[1].delay > 0);
    assert_non_null(strstr(world.notice, "things.1 is held up"));
    world_close(&world);
}

/// A balloon that sleeps on a box wakes when that begins to move, in substeps that are stable, and sleeps
/// again on the way's end.
static void a_thing_that_begins_to_move_wakes_what_lies_on_it(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, "step: 1e-3\nsleep_threshold: 0.01\n" BALLOON("0.105"),
              "things=[{model: box, size: [0.6, 0.2, 0.6], path: [{at: 2, position: [0, -0.1, 0]}, "
              "{at: 2.3, position: [0, 0, 0]}]}]");
    run_for(&world, 2);
    assert_true(world.balloon[0].body.asleep);
    const double before = probe(&world, "balloon0.cy");
    run_for(&world, 0.1);
    assert_false(world.balloon[0].body.asleep || world.blowup.halted);
    run_for(&world, 2);
    assert_true(world.balloon[0].body.asleep);
    assert_near(probe(&world, "balloon0.cy") - before, 0.1, 1e-3);
    assert_close(probe(&world, "thing0.fy"), -balloon_weight(&world), 2e-3);
    assert_int_equal(crossings_with_things(&world), 0);
    world_close(&world);
}

/// Two balloons between two plates: at rest both plates feel the same force, and what is pressed together
/// does not cross.
static void plates_that_press_two_balloons_feel_one_force(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "hug");
    run_for(&world, 1.45);
    assert_close(probe(&world, "thing0.fx"), -probe(&world, "thing1.fx"), 0.01);
    assert_less(probe(&world, "thing0.fx"), -2);
    assert_int_equal(crossings(&world), 0);
    assert_int_equal(crossings_with_things(&world), 0);
    run_for(&world, 1);
    assert_near(probe(&world, "thing0.fx"), 0, 0);
    assert_close(probe(&world, "balloon0.width"), 0.2, 0.01);
    world_close(&world);
}

/// A ball bounces off a box as off a floor, comes to rest at its radius and, pushed along, rolls with 5/7
/// of its speed over the triangles of the face.
static void balls_bounce_rest_and_roll_on_a_box(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(
        &world, "step: 1e-3\n" BALLOON("9.105"), "balloons.0.position=[9, 0.3, 0]",
        "things=[{model: box, size: [8, 0.2, 3], position: [0, -0.1, 0]}]",
        "spheres=[{position: [0.05, 1.1, 0.02], radius: 0.1, mass: 1, restitution: 0.8}, "
        "{position: "
        "[-1, 0.01, 0], radius: 0.001, mass: 1}, {position: [2.6, 0.2, 0.5], velocity: [-1, 0, 0], "
        "radius: 0.1, mass: 1, friction: 0.3}]");
    double top = 0;
    for (int n = 0; n < 1500; n++) {
        world_step(&world);
        if (n > 480)
            top = fmax(top, probe(&world, "sphere0.y"));
    }
    assert_close(top - 0.1, 0.64, 2e-3);
    assert_close(probe(&world, "sphere1.y"), 0.001, 1e-3);
    assert_near(probe(&world, "sphere2.y"), 0.1, 1e-5);
    assert_close(probe(&world, "sphere2.vx"), -5.0 / 7, 1e-3);
    assert_near(probe(&world, "pass_throughs"), 0, 0);
    world_close(&world);
}

/// Off a box and off the floor, at e = 0.8: e^2, e^4 of the height, however long the step.
static void balls_bounce_as_high_by_long_steps(void** state) {
    (void)state;
    static const char* const ground[] = {
        "things=[{model: box, size: [8, 0.2, 3], position: [0, -0.1, 0]}]", "floor=0"};
    static const char* const step[] = {"step=0.0166666666666666667", "step=0.004"};
    for (int k = 0; k < 4; k++) {
        World world;
        OPEN_TEXT(
            &world, "step: 1e-3\n" BALLOON("9.105"), "method=newton", step[k % 2],
            "balloons.0.position=[9, 0.3, 0]", "balloons.0.model=icosphere:1", ground[k / 2],
            "spheres=[{position: [0.05, 1.1, 0.02], radius: 0.1, mass: 1, restitution: 0.8}]");
        double top[2] = {0, 0};
        while (world_time(&world) < 1.6) {
            world_step(&world);
            double* now = &top[world_time(&world) > 1.15];
            if (world_time(&world) > 0.5)
                *now = fmax(*now, probe(&world, "sphere0.y") - 0.1);
        }
        assert_close(top[0], 0.64, 2e-3);
        assert_close(top[1], 0.4096, 2e-3);
        world_close(&world);
    }
}

static void a_ball_that_begins_across_a_box_is_moved_out(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, "step: 1e-3\n" BOX BALLOON("0.105"),
              "spheres=[{position: [0.2, 0.01, 0], radius: 0.05, mass: 1}]");
    assert_non_null(strstr(world.notice, "spheres.0 begins across things.0"));
    assert_near(probe(&world, "sphere0.y"), 0.05, 1e-4);
    world_close(&world);
}

static void refused_things_are_said_in_one_sentence(void** state) {
    (void)state;
    const struct {
        const char *set, *words;
    } refused[] = {
        {"things.0.size=[0.6, 0.4, 0.6]",
         "things.0 (box) crosses the skin of balloons.0 (icosphere:2)"},
        {"things=[{model: none.obj}]", "no model 'none.obj'"},
        {"things=[{model: 'box:0'}]", "write box:N"},
        {"contact=paper", "things: the penalty `contact: paper` knows no things"},
    };
    const char* path = file_of("step: 1e-3\n" BOX BALLOON("0.105"), ".yaml");
    for (size_t k = 0; k < sizeof refused / sizeof *refused; k++) {
        WorldDef def;
        World world;
        Fault fault = {0};
        assert_true(scene_load(path, &(SceneSet){refused[k].set}, 1, &def, &fault));
        assert_false(world_open(&world, &def, &fault));
        if (!strstr(fault.text, refused[k].words))
            fail_msg("%s: got %s", refused[k].set, fault.text);
    }
    remove(path);
}

/// At 1/60 s newton does not solve each step of the hug with its contacts. Those that it solves without
/// them are short enough that contacts, which then change the velocities, stretch nothing: the pressure
/// stays near that of short steps, 91.5 Pa when the plates are nearest, and only rises.
static void a_hug_by_long_steps_keeps_its_pressure(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "hug", "method=newton", "step=0.0166666666666666667");
    for (int n = 0; n < 64; n++) {
        world_step(&world);
        assert_false(world.blowup.halted);
        assert_less(probe(&world, "balloon0.gauge_pressure"), 160);
    }
    assert_near(probe(&world, "balloon0.gauge_pressure"), 91.5, 5);
    assert_near(probe(&world, "thing0.fx"), -2.137, 0.05);
    assert_int_equal(crossings(&world), 0);
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(balloon_at_rest_presses_with_its_weight),
        cmocka_unit_test(skins_never_cross_edges_and_spikes),
        cmocka_unit_test(momentum_of_a_pushed_balloon_is_the_things_impulse),
        cmocka_unit_test(a_thing_that_would_press_a_skin_to_nothing_is_held_up),
        cmocka_unit_test(a_thing_that_begins_to_move_wakes_what_lies_on_it),
        cmocka_unit_test(plates_that_press_two_balloons_feel_one_force),
        cmocka_unit_test(a_hug_by_long_steps_keeps_its_pressure),
        cmocka_unit_test(balls_bounce_rest_and_roll_on_a_box),
        cmocka_unit_test(balls_bounce_as_high_by_long_steps),
        cmocka_unit_test(a_ball_that_begins_across_a_box_is_moved_out),
        cmocka_unit_test(refused_things_are_said_in_one_sentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
