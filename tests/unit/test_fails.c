/// The museum of failures: every scene fails as its key `fails` says, and does not with its cure.
#include "worlds.h"

#include "world/fails.h"

enum { MAX_CURES = 8 };

/// Run the scene until the time of its failure, with or without its cure.
static void run_exhibit(World* world, const char* path, bool cured) {
    WorldDef def;
    Fault fault = {0};
    SceneSet cure[MAX_CURES];
    assert_true(scene_load(path, NULL, 0, &def, &fault));
    assert_non_null(def.fails);
    const int cures = cured ? (int)def.fails->cure_count : 0;
    assert_in_range(cures, cured, MAX_CURES);
    for (int k = 0; k < cures; k++)
        cure[k].text = def.fails->cure[k];
    WorldDef again;
    assert_true(scene_load(path, cure, cures, &again, &fault));
    assert_true(world_open(world, &again, &fault));
    run_for(world, def.fails->at);
    scene_free(&def);
}

static bool is_of_this_precision(const WorldDef* def) {
    return def->precision == PRECISION_ANY ||
           (def->precision == PRECISION_DOUBLE) == (sizeof(real) == sizeof(double));
}

static int failures;

static void fails_as_said(const char* path) {
    if (!strstr(path, "/fails/"))
        return;
    World world;
    run_exhibit(&world, path, false);
    if (is_of_this_precision(&world.def) && !fails_seen(&world))
        fail_msg("%s does not fail as it says", path);
    failures++;
    world_close(&world);
}

static void every_failure_fails_as_said(void** state) {
    (void)state;
    each_scene(fails_as_said);
    assert_true(failures >= 16);
}

static void is_cured(const char* path) {
    WorldDef def;
    Fault fault = {0};
    assert_true(scene_load(path, NULL, 0, &def, &fault));
    if (def.fails && def.fails->cure_count > 0) {
        World world;
        run_exhibit(&world, path, true);
        double value;
        if (world.blowup.halted || fails_seen(&world))
            fail_msg("%s fails though it is cured: %s", path, world.blowup.text);
        if (def.fails->truth && probe_value(&world, def.fails->output, &value))
            assert_close(value, *def.fails->truth, 0.02);
        world_close(&world);
    }
    scene_free(&def);
}

/// With the cure the scene does not fail, and has the right value if that is known: 2 % are the
/// exhibits' coarse meshes and long steps.
static void every_cure_cures(void** state) {
    (void)state;
    each_scene(is_cured);
}

static void fails_in_the_museum_only(const char* path) {
    WorldDef def;
    Fault fault = {0};
    assert_true(scene_load(path, NULL, 0, &def, &fault));
    assert_true((def.fails != NULL) == (strstr(path, "/fails/") != NULL));
    scene_free(&def);
}

/// Exactly the scenes in the museum have the key `fails`.
static void only_the_museum_fails(void** state) {
    (void)state;
    each_scene(fails_in_the_museum_only);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_failure_fails_as_said),
        cmocka_unit_test(every_cure_cures),
        cmocka_unit_test(only_the_museum_fails),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
