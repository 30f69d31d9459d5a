/// What things on a path hold: their own points, pinned particles and the ends of strings; and what these
/// pull with.
#include "crossings.h"

#define BALLOON                                                                                    \
    "balloons:\n  - model: capsule:8x12\n    scale: 0.1\n"                                         \
    "    skin: {springs: {structural: 40, shear: 10, flexion: 4}}\n"                               \
    "    mass: {per_particle: 0.0005}\n    inflation: {law: gas, amount: 1}\n"                     \
    "    damping: {rate: 20}\n"
#define PINNED BALLOON "    pins: [{at: [0, 0.2, 0], radius: 0.12, to_thing: 0}]\n"
#define PLATE "things: [{model: box, size: [0.2, 0.02, 0.2], position: [0, 0.212, 0]}]\n"

/// Where a point that turns by the angles about x, then y, then z is then [degrees].
static double4 turned(double4 a, double x, double y, double z) {
    const double angle[3] = {x * PI / 180, y * PI / 180, z * PI / 180};
    for (int k = 0; k < 3; k++) {
        double4 b = a;
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        b[u] = cos(angle[k]) * a[u] - sin(angle[k]) * a[v];
        b[v] = sin(angle[k]) * a[u] + cos(angle[k]) * a[v];
        a = b;
    }
    return a;
}

/// A box that is thrown about by its path: each point is where the closed form has it, also in steps
/// so long that it would turn by a radian in one.
static void a_thing_turns_as_its_path_says(void** state) {
    (void)state;
    const char* const step[] = {"step=0.001", "step=0.02"};
    for (int n = 0; n < 2; n++) {
        World world;
        OPEN_TEXT(&world, "step: 1e-3\n" BALLOON, "balloons.0.position=[5, 0, 0]", step[n],
                  "things=[{model: box, size: [0.2, 0.3, 0.4], rotation: [0, 0, 30], path: "
                  "[{position: [0, 0, 0], rotation: [10, 0, 0]}, "
                  "{at: 0.2, position: [0.5, 0, 0], rotation: [100, 360, 20]}]}]");
        const Thing* thing = &world.thing[0];
        for (double t = 0.1; t < 0.35; t += 0.1) {
            run_for(&world, 0.1);
            const double part = fmin(1, t / 0.2);
            for (int i = 0; i < thing->body.count; i++) {
                double4 from = to_double4(thing->start[i]); // back to before the first rotation
                from = turned(from, -10, 0, 0);
                const double4 want = turned(from, 10 + 90 * part, 360 * part, 20 * part) +
                                     (double4){0.5 * part, 0, 0, 0};
                assert_near(dlength(to_double4(thing->body.x[i]) - want), 0,
                            TOLERANCE(3e-6, 1e-12));
            }
        }
        world_close(&world);
    }
}

/// By every method pinned particles are at the plate's points while that turns and moves, and nothing
/// crosses.
static void pinned_particles_move_with_their_thing(void** state) {
    (void)state;
    const char* const method[] = {"method=euler", "method=newton", "method=xpbd",
                                  "method=projective"};
    for (int m = 0; m < 4; m++) {
        World world;
        OPEN_TEXT(&world, "step: 1e-3\ngravity: 0\n" PINNED, method[m],
                  "things=[{model: box, size: [0.2, 0.02, 0.2], path: [{position: [0, 0.212, 0]}, "
                  "{at: 0.2, position: [0.1, 0.25, 0], rotation: [0, 40, 30]}]}]");
        run_for(&world, 0.25);
        const Pins* pins = &world.contacts.pins;
        assert_true(pins->count > 8);
        for (int k = 0; k < pins->count; k++) {
            const Pin* pin = &pins->pin[k];
            const double4 want = turned(pin->start - (double4){0, 0.212, 0, 0}, 0, 40, 30) +
                                 (double4){0.1, 0.25, 0, 0};
            const double4 x = to_double4(pin->body->x[pin->particle]);
            assert_near(dlength(x - want), 0, 1e-4); // contacts cut drifts, and it comes back
            assert_near(dlength(x - thing_point(pin->thing, pin->start, 0)), 0,
                        TOLERANCE(1e-6, 1e-14));
        }
        assert_false(world.blowup.halted);
        assert_int_equal(exact_crossings(&world.balloon[0].body, &world.thing[0].body), 0);
        world_close(&world);
    }
}

/// What hangs from a plate, by pins or by a string, pulls on it with its weight, and has no moment where
/// it hangs below the middle.
static void what_hangs_from_a_thing_pulls_with_its_weight(void** state) {
    (void)state;
    const char* const held[] = {"balloons.0.pins=[{at: [0, 0.2, 0], radius: 0.12, to_thing: 0}]",
                                "balloons.0.strings=[{to_thing: 0, at: highest, stiffness: 20}]"};
    const char* const method[] = {"method=euler", "method=newton"};
    for (int m = 0; m < 4; m++) {
        World world;
        OPEN_TEXT(&world, "step: 1e-3\n" PLATE BALLOON, held[m / 2], method[m % 2],
                  m < 2 ? "sleep_threshold=0" : "things.0.position=[0, 0.32, 0]");
        run_for(&world, 3);
        assert_close(probe(&world, "thing0.fy"), -balloon_weight(&world), 2e-3);
        assert_near(probe(&world, "thing0.fx"), 0, 1e-3 * balloon_weight(&world));
        assert_near(probe(&world, "thing0.mz"), 0, 1e-3 * 0.2 * balloon_weight(&world));
        if (m >= 2)
            assert_close(probe(&world, "balloon0.string0.tension"), balloon_weight(&world), 2e-3);
        world_close(&world);
    }
}

/// A string to a thing's side: the moment about the thing's position is the lever times the tension.
static void a_string_to_a_side_turns_the_thing(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, "step: 1e-3\n" PLATE BALLOON, "things.0.position=[0.1, 0.32, 0]",
              "balloons.0.strings=[{to_thing: 0, at: highest, to_at: nearest, stiffness: 20}]");
    run_for(&world, 3);
    assert_close(probe(&world, "thing0.mz"), -0.1 * probe(&world, "thing0.fy"), 5e-3);
    world_close(&world);
}

/// Two plates wring a balloon: they feel the same moment against each other, it does not cross itself, and
/// wound back it is as before.
static void a_wrung_balloon_pulls_on_both_ends_and_never_crosses(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(
        &world, "step: 1e-3\ngravity: 0\ncontacts: {self: true}\n" BALLOON,
        "balloons.0.inflation.fill={to: 0.5, start: 0, seconds: 0.3}",
        "balloons.0.pins=[{at: [0, 0.2, 0], radius: 0.12, to_thing: 0}, "
        "{at: [0, -0.2, 0], radius: 0.12, to_thing: 1}]",
        "things=[{model: box, size: [0.2, 0.02, 0.2], path: [{position: [0, 0.212, 0]}, "
        "{at: 0.6, position: [0, 0.212, 0], rotation: [0, 200, 0]}]}, {model: box, size: [0.2, "
        "0.02, 0.2], path: [{position: [0, -0.212, 0]}, "
        "{at: 0.6, position: [0, -0.212, 0], rotation: [0, -200, 0]}]}]");
    for (int n = 0; n < 12; n++) {
        run_for(&world, 0.1);
        assert_int_equal(exact_crossings(&world.balloon[0].body, &world.balloon[0].body), 0);
    }
    assert_less(probe(&world, "thing0.my"), -0.05);
    assert_close(probe(&world, "thing0.my"), -probe(&world, "thing1.my"), 0.02);
    assert_close(probe(&world, "thing0.fy"), -probe(&world, "thing1.fy"), 0.02);
    world_close(&world);
}

/// A paddle that turns about the origin throws a free balloon: both momenta of the balloon change by what
/// the paddle's force and moment say, in each step.
static void a_turning_paddle_gives_what_its_columns_say(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(
        &world, "step: 1e-3\ngravity: 0\n" BALLOON, "balloons.0.damping=~",
        "balloons.0.position=[0.15, 0.215, 0]",
        "things=[{model: box, size: [0.5, 0.02, 0.3], path: [{position: [0, 0, 0]}, {at: 0.2, "
        "position: [0, 0, 0], rotation: [0, 30, 60]}]}]");
    const char* const column[2][6] = {
        {"balloon0.px", "balloon0.py", "balloon0.pz", "balloon0.lx", "balloon0.ly", "balloon0.lz"},
        {"thing0.fx", "thing0.fy", "thing0.fz", "thing0.mx", "thing0.my", "thing0.mz"}};
    double before[6] = {0}, moment = 0;
    for (int n = 0; n < 250; n++) {
        world_step(&world);
        for (int k = 0; k < 6; k++) {
            const double now = probe(&world, column[0][k]), load = probe(&world, column[1][k]);
            assert_near(now - before[k], -load * world.step, TOLERANCE(1e-6, 1e-13));
            before[k] = now;
            moment = fmax(moment, fabs(load));
        }
    }
    assert_less(0.1, moment);
    assert_int_equal(exact_crossings(&world.balloon[0].body, &world.thing[0].body), 0);
    world_close(&world);
}

static void a_sleeping_balloon_wakes_when_its_thing_moves(void** state) {
    (void)state;
    World world;
    OPEN_TEXT(&world, "step: 1e-3\nsleep_threshold: 0.01\n" PINNED,
              "things=[{model: box, size: [0.2, 0.02, 0.2], path: [{at: 2.5, position: [0, 0.212, "
              "0]}, {at: 2.6, position: [0, 0.3, 0]}]}]");
    run_for(&world, 2.5);
    assert_true(world.balloon[0].body.asleep);
    const double before = probe(&world, "balloon0.cy");
    run_for(&world, 2.5);
    assert_near(probe(&world, "balloon0.cy") - before, 0.088, 1e-4);
    world_close(&world);
}

static void refused_pins_and_paths_are_said_in_one_sentence(void** state) {
    (void)state;
    const struct {
        const char *set, *words;
    } refused[] = {
        {"balloons.0.pins=[{at: [0, 0.2, 0], radius: 0.1, to_thing: 1}]",
         "to_thing must be the number of one of the scene's `things`, counted from 0"},
        {"balloons.0.strings=[{to_thing: 1, stiffness: 1}]",
         "to_thing that of one of its `things`"},
        {"balloons.0.strings=[{to_thing: 0, to: [0, 0, 0], stiffness: 1}]", "leads to one end"},
        {"balloons.0.strings=[{to_thing: 0, to_at: 9999, stiffness: 1}]", "box has points 0 to"},
        {"balloons.0.pins=[{at: [0, 0.4, 0], radius: 0.1}]",
         "balloons.0.pins.0: no particle of capsule:8x12 is within 0.1 m"},
        {"balloons.0.pins=[{at: [0, 0, 0], radius: 1}]", "they hold all particles of capsule:8x12"},
        {"things.0={model: box, size: [0.2, 0.02, 0.2], path: [{position: [0, 0.212, 0]}, {at: "
         "0.1, "
         "position: [0, 0.212, 0], rotation: [0, 4000, 0]}]}",
         "things.0.path: a point 0.142 m from its middle would move at up to 99 m/s"},
        {"knots=[{path: [{position: [0, 0, 0], rotation: [1, 0, 0]}]}]",
         "a knot is a point and has no rotation"},
        {"method=xpbd", "takes no string to a balloon, a knot or a thing; take euler, newton"},
    };
    const char* path = file_of(
        "step: 1e-3\n" PLATE BALLOON "    strings: [{to_thing: 0, stiffness: 1}]\n", ".yaml");
    for (size_t k = 0; k < sizeof refused / sizeof *refused; k++) {
        WorldDef def;
        World world;
        Fault fault = {0};
        if (scene_load(path, &(SceneSet){refused[k].set}, 1, &def, &fault))
            assert_false(world_open(&world, &def, &fault));
        if (!strstr(fault.text, refused[k].words))
            fail_msg("%s: got %s", refused[k].set, fault.text);
    }
    remove(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_thing_turns_as_its_path_says),
        cmocka_unit_test(pinned_particles_move_with_their_thing),
        cmocka_unit_test(what_hangs_from_a_thing_pulls_with_its_weight),
        cmocka_unit_test(a_string_to_a_side_turns_the_thing),
        cmocka_unit_test(a_wrung_balloon_pulls_on_both_ends_and_never_crosses),
        cmocka_unit_test(a_turning_paddle_gives_what_its_columns_say),
        cmocka_unit_test(a_sleeping_balloon_wakes_when_its_thing_moves),
        cmocka_unit_test(refused_pins_and_paths_are_said_in_one_sentence),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
