/// Overrides from the command line, --set KEY=VALUE.
#include "scenes.h"

#include "force/force.h"

static void an_override_changes_what_the_file_says(void** state) {
    (void)state;
    const char* const set[] = {"step=0.5", "balloons.0.color=[0, 1, 0]",
                               "balloons.0.strings.1.at=lowest", NULL};
    WorldDef def;
    must_load(full, set, &def);
    assert_true(def.step == 0.5);
    assert_vector(def.balloons->color, 0, 1, 0);
    assert_string_equal(def.balloons->strings[1].at, "lowest");
    assert_true(def.balloons->strings[1].stiffness == 7);
    scene_free(&def);
}

static void an_override_makes_the_keys_that_are_absent(void** state) {
    (void)state;
    const char* const set[] = {"balloons.0.inflation.fill={to: 3, seconds: 1}",
                               "balloons.0.inflation.law=area",
                               "title='It''s \"so\": \u00e4 \xf0\x9f\x8e\x88' # not this", NULL};
    WorldDef def;
    must_load(smallest, set, &def);
    assert_true(def.balloons->inflation->law == INFLATE_AREA);
    assert_true(def.balloons->inflation->fill->to == 3);
    assert_string_equal(def.title, "It's \"so\": \u00e4 \xf0\x9f\x8e\x88");
    scene_free(&def);
}

static void an_override_takes_a_key_out(void** state) {
    (void)state;
    const char* const set[] = {"floor=~", "balloons.0.strings=~", "balloons.0.helium.nothing=~",
                               NULL};
    WorldDef def;
    must_load(full, NULL, &def);
    assert_true(def.floor && def.balloons->strings_count > 0);
    scene_free(&def);
    must_load(full, set, &def);
    assert_true(!def.floor && def.balloons->strings_count == 0 &&
                def.balloons->force[FORCE_HELIUM]);
    scene_free(&def);
    const char* const item[] = {"balloons.0.strings.0=~", NULL};
    must_refuse(full, item, "--set balloons.0.strings.0=~", "items of a list stay");
}

static void the_last_of_two_overrides_holds(void** state) {
    (void)state;
    const char* const set[] = {"step=0.5", "step=0.25", NULL};
    WorldDef def;
    must_load(smallest, set, &def);
    assert_true(def.step == 0.25);
    scene_free(&def);
}

static void an_override_mends_what_is_wrong_in_the_file(void** state) {
    (void)state;
    const char* const set[] = {"step=0.5", NULL};
    WorldDef def;
    must_load("step: 7\nballoons: [{model: cube, mass: {per_particle: 1}}]\n", set, &def);
    assert_true(def.step == 0.5);
    scene_free(&def);
}

static void a_fault_of_the_file_keeps_its_line_under_overrides(void** state) {
    (void)state;
    char location[96];
    snprintf(location, sizeof location, "%s:5", scene);
    const char* const set[] = {"step=0.5", "balloons.0.turn=1", NULL};
    must_refuse(HEAD "    scale: 0\n", set, location, "balloons.0.scale must be greater than 0");
}

static void what_an_override_does_wrong_is_said_of_it(void** state) {
    (void)state;
    // clang-format off
    static const char* const wrong[][2] = {
        {"balloons.0.foo=3",      "no key 'foo' in balloons.0; there are model"},
        {"foo.bar=3",             "no key 'foo' in a scene"},
        {"step=2",                "step must be greater than 0 and at most 1, not 2"},
        {"step=",                 "step must be a number, not ''"},
        {"step",                  "this is not KEY=VALUE"},
        {"=3",                    "this is not KEY=VALUE"},
        {"",                      "this is not KEY=VALUE"},
        {"step.foo=3",            "step is one value and has no keys"},
        {"balloons.1.scale=3",    "balloons has no item '1'; it is a list of 1, counted from 0"},
        {"balloons.-1.scale=3",   "balloons has no item '-1'"},
        {"balloons.00x.scale=3",  "balloons has no item '00x'"},
        {"balloons.99999999999999999999=3", "balloons has no item '99999999999999999999'"},
        {"balloons.0.color.1=1",  "there is no list balloons.0.color yet"},
        {"balloons.0.color=[1, 1", "this is not YAML"},
        {"balloons.0.color=red",  "balloons.0.color must be a list of 3 numbers"},
        {"balloons.0=&a [*a]",    "this value is too large"},
        {"balloons.0.damping={rate: 1, coefficient: 1}", "give coefficient or rate, not both"},
        {"balloons.0.mass.rate=2", "no key 'rate' in balloons.0.mass; there are per_particle"},
        {"method=magic",          "no method 'magic'; there are euler"},
    };
    // clang-format on
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        char location[128];
        snprintf(location, sizeof location, "--set %s", wrong[i][0]);
        must_refuse(smallest, (const char* const[]){wrong[i][0], NULL}, location, wrong[i][1]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_override_changes_what_the_file_says),
        cmocka_unit_test(an_override_makes_the_keys_that_are_absent),
        cmocka_unit_test(an_override_takes_a_key_out),
        cmocka_unit_test(the_last_of_two_overrides_holds),
        cmocka_unit_test(an_override_mends_what_is_wrong_in_the_file),
        cmocka_unit_test(a_fault_of_the_file_keeps_its_line_under_overrides),
        cmocka_unit_test(what_an_override_does_wrong_is_said_of_it),
    };
    return cmocka_run_group_tests_name("scene_set", tests, make_folder, remove_folder);
}
