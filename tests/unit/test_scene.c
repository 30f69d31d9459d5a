/// The scene format: every key loads, names find their files, mutations never crash.
#include "scenes.h"

#include "force/damping.h"
#include "force/helium.h"
#include "scene/key.h"
#include "solve/method.h"
#include "view/mode.h"

static void every_key_of_a_world_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);

    assert_string_equal(def.title, "All there is");
    assert_int_equal(def.units, UNITS_PAPER);
    assert_true(def.step == 0.002);
    assert_true(def.gravity && *def.gravity == 0);
    assert_true(def.floor && *def.floor == -3.5);
    assert_int_equal(def.guard, GUARD_STOP);
    assert_int_equal(def.precision, PRECISION_DOUBLE);
    assert_string_equal(def.method, "euler");
    assert_string_equal(def.show, "springs");
    assert_true(def.sleep_threshold == 0.001);
    assert_true(def.seconds == 12);
    assert_vector(def.camera->eye, 1, 2, 3);
    assert_vector(def.camera->look, 4, 5, 6);
    assert_int_equal(def.about_count, 1);
    assert_string_equal(def.about[0].output, "balloon0.cy");
    assert_true(def.about[0].at == 20 && def.about[0].tolerance == 0.05);
    const FailsDef* fails = def.fails;
    assert_true(fails->at == 2 && !fails->halts && *fails->above == 0.5 && *fails->truth == -1);
    assert_string_equal(fails->output, "balloon0.cy");
    assert_null(fails->below);
    assert_int_equal(fails->cure_count, 2);
    assert_string_equal(fails->cure[1], "gravity=1");
    assert_int_equal(def.balloons_count, 2);
    const SolverDef* solver = &def.solver;
    assert_true(solver->iterations == 7 && solver->tolerance == 1e-5);
    assert_true(solver->linear_tolerance == 1e-3 && solver->fixed && solver->paper_tangent);
    assert_true(solver->in_place);
    assert_int_equal(solver->start, START_REST);
    assert_int_equal(def.pipes_count, 1);
    assert_true(def.pipes[0].from == 0 && def.pipes[0].to == 1);
    assert_true(def.pipes[0].conductance == 1e-3 && def.pipes[0].start == 0.5);
    assert_string_equal(def.file, scene);
    scene_free(&def);
}

static void every_key_of_rubber_and_gas_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);
    const MembraneDef* rubber = def.balloons[1].skin.membrane;
    assert_string_equal(rubber->material, "stvk-3d");
    assert_true(rubber->young == 1e6 && rubber->parameter[0] == 0.4);
    assert_true(rubber->density == 1000 && rubber->thickness == 3e-4);
    assert_int_equal(rubber->volume, VOLUME_LOCAL);
    assert_int_equal(rubber->patches_count, 1);
    assert_vector(rubber->patches[0].at, 0, 1, 0);
    assert_true(rubber->patches[0].radius == 0.5 && rubber->patches[0].thickness == 1e-4);
    const InflationDef* gas = def.balloons[0].inflation;
    assert_true(*gas->unit == 2e5 && *gas->temperature == 300 && gas->adiabatic);
    assert_true(gas->leak == 1e-6 && gas->vent == 1e-5);
    assert_string_equal(gas->filling, "helium");
    scene_free(&def);

    // which no skin that touches may have
    must_load(full,
              (const char*[]){"contacts={}", "things=[]", "balloons.0.strings=[]",
                              "balloons.0.pins=[]", "balloons.1.skin.membrane.volume=global", NULL},
              &def);
    assert_int_equal(def.balloons[1].skin.membrane->volume, VOLUME_GLOBAL);
    scene_free(&def);
}

static void every_key_of_spheres_and_walls_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);
    assert_int_equal(def.contact, CONTACT_PAPER);
    assert_int_equal(def.spheres_count, 1);
    const SphereDef* sphere = &def.spheres[0];
    assert_vector(sphere->position, 1, 2, 3);
    assert_vector(sphere->velocity, 4, 5, 6);
    assert_true(sphere->radius == 0.5 && sphere->mass == 2);
    assert_true(sphere->restitution == 0.25 && sphere->friction == 0.75);
    assert_int_equal(def.walls_count, 1);
    assert_vector(def.walls[0].at, 0, 0, -7);
    assert_vector(def.walls[0].normal, 0, 0, 2);
    scene_free(&def);
}

static void every_key_of_things_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);
    const ThingDef* thing = def.things;
    assert_vector(thing->size, 1, 2, 3);
    assert_vector(thing->rotation, 10, 20, 30);
    assert_vector(thing->color, 1, 0.5, 0);
    assert_true(thing->scale == 2 && thing->friction == 0.25);
    assert_true(thing->path_count == 2 && thing->path[0].at == 1 && thing->path[1].at == 3);
    assert_vector(thing->path[1].position, 4, 1, 0);
    scene_free(&def);
}

static void every_key_of_a_balloon_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);

    const BalloonDef* balloon = def.balloons;
    assert_string_equal(balloon->model, "cube-sphere:4");
    assert_vector(balloon->position, 1, -2, 0.3);
    assert_true(balloon->size == 2 && balloon->scale == 3 && balloon->rotation == 90);
    assert_vector(balloon->color, 0.1, 0.2, 1);
    const SpringsDef* springs = balloon->skin.springs;
    assert_true(springs->structural == 50 && springs->shear == 10 && springs->flexion == 11);
    assert_true(springs->torsion == 12 && springs->law == LAW_RUBBER);
    assert_true(balloon->mass->per_particle == 0.001);
    assert_true(balloon->hold_rim);
    const double* helium = balloon->force[FORCE_HELIUM];
    assert_true(helium[HELIUM_BASE] == 20 && helium[HELIUM_PER_INFLATION] == 5);
    const double* damping = balloon->force[FORCE_DAMPING];
    assert_true(damping[DAMPING_COEFFICIENT] == 0.2 && damping[DAMPING_RATE] == 0);
    const StrainLimitDef* limit = balloon->strain_limit;
    assert_true(limit->structural == 0.1 && limit->shear == 0.2);
    assert_true(limit->flexion == 0.3 && limit->tarantino && limit->phantom);
    scene_free(&def);
}

static void every_key_of_inflation_loads_into_its_field(void** state) {
    (void)state;
    WorldDef def;
    must_load(full, NULL, &def);

    const InflationDef* inflation = def.balloons->inflation;
    assert_int_equal(inflation->law, INFLATE_GAS);
    assert_true(inflation->amount == 1.5 && inflation->rate == 2);
    assert_true(inflation->min == 0.5 && inflation->max == 9 && *inflation->ambient == 1e5);
    const FillDef* filling = inflation->fill;
    assert_true(filling->to == 3 && filling->start == 0.25 && filling->seconds == 0.5);
    scene_free(&def);
}

static void what_a_scene_does_not_name_is_absent(void** state) {
    (void)state;
    WorldDef def;
    must_load(smallest, NULL, &def);

    const WorldDef got = def;
    assert_true(!got.title && !got.gravity && !got.floor && !got.method && !got.show);
    assert_true(!got.camera && !got.about && got.about_count == 0 && got.seconds == 10);
    assert_int_equal(got.units, UNITS_SI);
    assert_int_equal(got.guard, GUARD_SPLIT);
    assert_int_equal(got.precision, PRECISION_ANY);
    const BalloonDef* b = got.balloons;
    assert_true(!b->position && !b->color && !b->skin.springs && !b->inflation);
    for (int k = 0; k < FORCES; k++)
        assert_null(b->force[k]);
    assert_true(!b->strain_limit && !b->strings && b->strings_count == 0);
    assert_true(b->size == 0 && b->scale == 1 && b->rotation == 0 && !b->hold_rim);
    scene_free(&def);
}

// The example of the scene format, with its comments.
static void a_scene_with_lists_in_one_line_and_comments_loads(void** state) {
    (void)state;
    static const char text[] =
        "# Figures 19-21: tied by its tail, the squirrel turns upside down.\n"
        "units: paper\n"
        "step: 0.002\n"
        "about: [{output: balloon0.cy, at: 20, tolerance: 0.05}]     # for `needs`\n"
        "balloons:\n"
        "  - model: squirrel.obj                 # or cube, cube-sphere:12, torus:24x12\n"
        "    skin:      {springs: {structural: 50, shear: 10, flexion: 10, law: hooke}}\n"
        "    mass:      {per_particle: 0.001}\n"
        "    inflation: {law: area, amount: 20}\n"
        "    helium:    {base: 20, per_inflation: 5}\n"
        "    damping:   {coefficient: 0.2}       # or {rate: 50}, times mass\n"
        "    strings:   [{to: [0, -6, 0], at: nearest, stiffness: 50, slack: 1.2}]\n";
    WorldDef def;
    must_load(text, NULL, &def);
    assert_string_equal(def.balloons->model, "squirrel.obj");
    assert_true(def.balloons->inflation->amount == 20);
    assert_vector(def.balloons->strings->to, 0, -6, 0);
    scene_free(&def);
}

static void what_an_alias_stands_for_is_copied(void** state) {
    (void)state;
    static const char text[] = "step: 0.01\n"
                               "balloons:\n"
                               "  - model: cube\n"
                               "    mass: &m {per_particle: 0.5}\n"
                               "  - {model: cube, mass: *m}\n";
    WorldDef def;
    must_load(text, NULL, &def);
    assert_true(def.balloons[1].mass->per_particle == 0.5);
    scene_free(&def);

    const char* const set[] = {"balloons.1.mass.per_particle=2", NULL};
    must_load(text, set, &def);
    assert_true(def.balloons[0].mass->per_particle == 0.5);
    assert_true(def.balloons[1].mass->per_particle == 2);
    scene_free(&def);
}

static void a_bare_mesh_is_a_balloon_on_a_string(void** state) {
    (void)state;
    const SceneSet set[] = {{"balloons.0.inflation.amount=7"}};
    WorldDef def;
    Fault fault = {0};
    assert_true(shape_count > 0);
    for (int i = 0; i < shape_count; i++) {
        assert_true(scene_load(shape_table[i].name, set, 1, &def, &fault));
        assert_string_equal(def.balloons->model, shape_table[i].name);
        assert_true(def.balloons->skin.springs->structural == 50 && def.balloons->size == 2);
        assert_true(def.balloons->inflation->amount == 7 && def.floor);
        assert_string_equal(def.balloons->strings->at, "lowest");
        scene_free(&def);
    }
}

static void a_mesh_is_named_by_its_path_and_found_again(void** state) {
    (void)state;
    WorldDef def;
    Fault fault = {0};
    write_bytes(beside, "v 0 0 0\n", 8);
    assert_true(scene_load(beside, NULL, 0, &def, &fault));
    char path[512];
    assert_true(scene_model_path(&def, def.balloons->model, path, &fault));
    assert_string_equal(path, beside);
    scene_free(&def);
}

static void a_model_is_found_beside_its_scene(void** state) {
    (void)state;
    WorldDef def;
    Fault fault = {0};
    char path[512];
    write_bytes(beside, "v 0 0 0\n", 8);
    must_load(smallest, NULL, &def);

    assert_true(scene_model_path(&def, "beside.obj", path, &fault));
    assert_string_equal(path, beside);
    assert_true(scene_model_path(&def, beside, path, &fault));
    assert_string_equal(path, beside);
    assert_true(scene_model_path(&def, "cube", path, &fault));
    assert_string_equal(path, "cube");
    assert_false(scene_model_path(&def, "none.obj", path, &fault));
    assert_string_equal(fault.location, scene);
    assert_non_null(strstr(fault.text, "no model 'none.obj'; it is not beside the scene, in "
                                       "assets/models or in the working folder"));
    scene_free(&def);
}

static void every_shipped_scene_is_found_by_its_name(void** state) {
    (void)state;
    char** path;
    const int count = scene_list(&path);
    for (int i = 0; i < count; i++) {
        assert_true(i == 0 || strcmp(path[i - 1], path[i]) < 0);
        char name[256];
        scene_name(path[i], name);
        assert_null(strstr(name, ".yaml"));
        WorldDef def;
        Fault fault = {0};
        if (!scene_load(name, NULL, 0, &def, &fault))
            fail_msg("%s: %s", fault.location, fault.text);
        assert_string_equal(def.file, path[i]);
        scene_free(&def);
    }
    for (int i = 0; i < count; i++)
        free(path[i]);
    free(path);
}

static void a_name_that_is_nothing_is_told_what_there_is(void** state) {
    (void)state;
    static const char* const name[] = {
        "nothing", "nothing.yaml", "nothing.obj", "nothing:3", "", "/", ".."};
    for (size_t i = 0; i < sizeof name / sizeof name[0]; i++) {
        WorldDef def;
        Fault fault = {0};
        assert_false(scene_load(name[i], NULL, 0, &def, &fault));
        assert_string_equal(fault.location, name[i]);
        assert_non_null(strstr(fault.text, "there is no such scene or mesh, here or in "
                                           "assets/scenes and assets/models; scenes are "));
        assert_non_null(strstr(fault.text, shape_table[0].name));
    }
}

static void numbers_have_a_point_in_every_locale(void** state) {
    (void)state;
    static const char* const with_comma[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR"};
    bool found = false;
    for (int i = 0; i < 4 && !found; i++)
        found = setlocale(LC_NUMERIC, with_comma[i]);
    if (!found)
        skip(); // this machine has no locale with a comma
    WorldDef def;
    Fault fault;
    const bool good = load(full, NULL, &def, &fault);
    char one[8];
    snprintf(one, sizeof one, "%.1f", 0.5);
    setlocale(LC_NUMERIC, "C");
    assert_string_equal(one, "0,5");
    assert_true(good && def.step == 0.002);
    scene_free(&def);
}

static const char* absent(const char* name) {
    Key key;
    assert_true(key_find(&scene_keys, NULL, name, &key));
    return key.absent;
}

static double default_of(const KeyGroup* group, const char* name) {
    Key key;
    assert_true(key_find(group, NULL, name, &key));
    return key.is.default_value;
}

/// Defaults that other folders define are equal to those in the rows.
static void defaults_of_rows_are_those_of_the_program(void** state) {
    (void)state;
    Key inflation;
    assert_true(key_find(&balloon_keys, NULL, "inflation", &inflation));
    assert_true(default_of(inflation.group, "ambient") == standard_pressure);
    assert_true(default_of(inflation.group, "temperature") == standard_temperature);
    char word[80];
    snprintf(word, sizeof word, "`%s`", method_table[0]->name);
    assert_string_equal(absent("method"), word);
    snprintf(word, sizeof word, "`%s`", mode_table[0]->name);
    assert_string_equal(absent("show"), word);

    const WorldDef si = {.units = UNITS_SI}, paper = {.units = UNITS_PAPER};
    snprintf(word, sizeof word, "%g, or %g in the paper's units", scene_gravity(&si),
             scene_gravity(&paper));
    assert_string_equal(absent("gravity"), word);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_key_of_a_world_loads_into_its_field),
        cmocka_unit_test(every_key_of_rubber_and_gas_loads_into_its_field),
        cmocka_unit_test(every_key_of_spheres_and_walls_loads_into_its_field),
        cmocka_unit_test(every_key_of_things_loads_into_its_field),
        cmocka_unit_test(every_key_of_a_balloon_loads_into_its_field),
        cmocka_unit_test(every_key_of_inflation_loads_into_its_field),
        cmocka_unit_test(what_a_scene_does_not_name_is_absent),
        cmocka_unit_test(a_scene_with_lists_in_one_line_and_comments_loads),
        cmocka_unit_test(defaults_of_rows_are_those_of_the_program),
        cmocka_unit_test(what_an_alias_stands_for_is_copied),
        cmocka_unit_test(a_bare_mesh_is_a_balloon_on_a_string),
        cmocka_unit_test(a_mesh_is_named_by_its_path_and_found_again),
        cmocka_unit_test(a_model_is_found_beside_its_scene),
        cmocka_unit_test(every_shipped_scene_is_found_by_its_name),
        cmocka_unit_test(a_name_that_is_nothing_is_told_what_there_is),
        cmocka_unit_test(numbers_have_a_point_in_every_locale),
    };
    return cmocka_run_group_tests_name("scene", tests, make_folder, remove_folder);
}
