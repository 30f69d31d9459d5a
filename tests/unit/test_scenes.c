/// Every shipped scene, and results of the mass-spring paper's figures.
#include "worlds.h"

#include "force/force.h"

/// With a volume constraint the total rubber volume is constant to rounding, 1e-16 and 1e-7 of it.
static void check_rubber(const World* world, const char* path) {
    for (int b = 0; b < world->balloon_count; b++) {
        char output[64];
        double ratio;
        snprintf(output, sizeof output, "balloon%d.rubber_volume", b);
        if (!probe_value(world, output, &ratio))
            continue;
        if (!(fabs(ratio - 1) < TOLERANCE(1e-6, 1e-9)))
            fail_msg("%s: %s is 1 %+g", path, output, ratio - 1);
    }
}

static void runs_and_stays_finite(const char* path) {
    World world;
    WORLD_OF(&world, path);
    // an implicit step of a skin costs a hundred explicit ones; double's hashes run 1 s
    run_for(&world, world.method == &method_newton ? 0.25 : TOLERANCE(5, 0.1));
    if (!is_finite(&world) || (world.blowup.halted && !world.def.fails))
        fail_msg("%s: %s", path, world.blowup.text);
    if (!world.def.fails)
        check_rubber(&world, path);
    world_close(&world);
}

/// The scenes of the museum of failures are tested by test_fails.c.
static void every_scene_runs_and_stays_finite(void** state) {
    (void)state;
    assert_true(each_scene(runs_and_stays_finite) >= 10);
}

static void is_about_something(const char* path) {
    World world;
    WORLD_OF(&world, path);
    if (world.def.about_count == 0 || (world.def.fails && scene_outputs(&world.def) > 0))
        fail_msg("%s must say what it is about", path);
    for (unsigned n = 0; n < scene_outputs(&world.def); n++) {
        probe(&world, world.def.about[n].output);
        assert_less(world.def.about[n].at, 1.0001 * fmax(10, world.def.seconds));
    }
    world_close(&world);
}

/// Each names outputs that it has, or a reason why it names none; scenes of failures have `fails`.
static void every_scene_is_about_something(void** state) {
    (void)state;
    each_scene(is_about_something);
}

static void starts_at_rest(const char* path) {
    World world;
    WORLD_OF(&world, path);
    for (int b = 0; b < world.balloon_count; b++) {
        const Body* body = &world.balloon[b].body;
        assert_near(force_springs.energy(body), 0, 1e-9);
        for (int i = 0; i < body->count; i++)
            assert_near((double)length(body->v[i]), 0, 0);
    }
    world_close(&world);
}

/// A scene whose balloons start at rest and unstretched has no elastic energy, and no velocity.
static void every_scene_starts_at_rest(void** state) {
    (void)state;
    each_scene(starts_at_rest);
}

/// Mean height of the particles that lie in a slab of the first shape [0, 1] from low to high.
static double slab_height(const Balloon* balloon, double low, double high) {
    const Mesh* mesh = &balloon->mesh;
    double bottom = INFINITY, top = -INFINITY, sum = 0;
    for (int i = 0; i < mesh->point_count; i++) {
        bottom = fmin(bottom, mesh->point[i][1]);
        top = fmax(top, mesh->point[i][1]);
    }
    int count = 0;
    for (int i = 0; i < mesh->point_count; i++) {
        const double part = (mesh->point[i][1] - bottom) / (top - bottom);
        // the body alone, in front of the tail
        if (part < low || part > high || mesh->point[i][2] < 0)
            continue;
        sum += (double)balloon->body.x[i][1];
        count++;
    }
    assert_true(count > 10);
    return sum / count;
}

/// Figures 19 to 21: feet below the head at first, head below the feet in the end.
static void tied_squirrel_turns_upside_down(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "squirrel-turns");
    const Balloon* squirrel = &world.balloon[0];
    const double upright = slab_height(squirrel, 0.7, 1) - slab_height(squirrel, 0, 0.2);
    assert_less(0.5, upright);
    run_for(&world, world.def.seconds);
    const double difference = slab_height(squirrel, 0.7, 1) - slab_height(squirrel, 0, 0.2);
    assert_less(difference, -0.5 * upright);
    world_close(&world);
}

static double sphericity(const World* world) {
    const double volume = probe(world, "balloon0.volume"), area = probe(world, "balloon0.area");
    return cbrt(36 * PI * volume * volume) / area;
}

/// Figures 24 and 25.
static void bowl_becomes_a_ball(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "bowl-to-ball");
    assert_less(sphericity(&world), 0.7);
    run_for(&world, world.def.seconds);
    assert_less(0.95, sphericity(&world));
    world_close(&world);
}

/// Figures 1 and 2: its volume has grown, and so have its thinnest parts.
static void blown_up_squirrel_holds_more(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "squirrel-inflates");
    const double before = probe(&world, "balloon0.volume");
    run_for(&world, world.def.seconds);
    assert_less(1.5 * before, probe(&world, "balloon0.volume"));
    world_close(&world);
}

/// Figures 11 and 12: with correction the turtle is smaller and its springs are shorter.
static void corrected_turtle_is_held(void** state) {
    (void)state;
    double volume[2], stretch[2];
    for (int k = 0; k < 2; k++) {
        World world;
        WORLD_OF(&world, k ? "turtle-corrected" : "turtle");
        run_for(&world, world.def.seconds);
        volume[k] = probe(&world, "balloon0.volume");
        stretch[k] = probe(&world, "balloon0.stretch_max");
        world_close(&world);
    }
    assert_less(volume[1], 0.9 * volume[0]);
    assert_less(stretch[1], 0.9 * stretch[0]);
}

/// Particle numbers in a scene are those of the model's file.
static void loaded_numbers_name_the_model_s_vertices(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "squirrel-turns");
    const Mesh* mesh = &world.balloon[0].mesh;
    char path[512], line[256];
    Fault fault = {0};
    assert_true(scene_model_path(&world.def, "squirrel.obj", path, &fault));
    FILE* obj = fopen(path, "r");
    assert_non_null(obj);
    int k = 0; // the shipped models' vertices stand in the order of first use
    double x, y, z;
    while (fgets(line, sizeof line, obj))
        if (sscanf(line, "v %lf %lf %lf", &x, &y, &z) == 3) {
            const double4 p = mesh->point[mesh->inside[k]];
            assert_near(p[0], x, 0);
            assert_near(p[1], y, 0);
            assert_near(p[2], z, 0);
            assert_int_equal(mesh->loaded[mesh->inside[k]], k);
            k++;
        }
    fclose(obj);
    assert_int_equal(k, mesh->point_count);
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_runs_and_stays_finite),
        cmocka_unit_test(every_scene_is_about_something),
        cmocka_unit_test(every_scene_starts_at_rest),
        cmocka_unit_test(tied_squirrel_turns_upside_down),
        cmocka_unit_test(bowl_becomes_a_ball),
        cmocka_unit_test(blown_up_squirrel_holds_more),
        cmocka_unit_test(corrected_turtle_is_held),
        cmocka_unit_test(loaded_numbers_name_the_model_s_vertices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
