/// The map of a scene's stable steps: its cells agree with theory, independent of the parts in
/// which it is measured, and a cell's scene is the scene with that step and stiffness.
#include "worlds.h"

#include "lab/stability/map.h"

static int measure(Map* map) {
    int parts = 0;
    while (map_work(map))
        parts++;
    return parts;
}

static void cells_are_stable_below_the_limit_and_not_above(void** state) {
    (void)state;
    const char* const scene[] = {"limit-springs", "sphere-gas", "sphere-pressure"};
    for (int s = 0; s < 3; s++) {
        World world;
        Map map;
        WORLD_OF(&world, scene[s]);
        run_for(&world, 0.05);
        map_begin(&map, &world, NULL, 0);
        // an explicit method makes 64 steps a part: 2,000 steps of each cell are 32 at most
        assert_in_range(measure(&map), MAP_ROWS * MAP_COLUMNS + 1, MAP_ROWS * MAP_COLUMNS * 33);
        assert_string_equal(map.why, "");
        for (int r = 0; r < MAP_ROWS; r++) {
            assert_true(map.bound[r] > 0 && map.bound[r] <= map.theory[r]);
            for (int c = 0; c < MAP_COLUMNS; c++) {
                const double h = map_step(&map, c);
                // near its limit a stable mode of an undamped body beats (lab/stability/trial.c)
                const bool inside = h<0.9 * map.theory[r], outside = h> 1.02 * map.theory[r];
                if ((inside && map.cell[r][c] != VERDICT_STABLE) ||
                    (outside && map.cell[r][c] == VERDICT_STABLE) || map.cell[r][c] == MAP_UNKNOWN)
                    fail_msg("%s: %g s, stiffness x %g: %d, limit %g s", scene[s], h,
                             map_stiffness(r), map.cell[r][c], map.theory[r]);
            }
        }
        map_end(&map);
        world_close(&world);
    }
}

/// truth: of these springs w^2 = 221899.946, gamma = 200; w^2 grows with the stiffness.
static void theory_is_that_of_the_stiffened_skin(void** state) {
    (void)state;
    World world;
    Map map;
    WORLD_OF(&world, "limit-springs");
    map_begin(&map, &world, NULL, 0);
    measure(&map);
    for (int r = 0; r < MAP_ROWS; r++) {
        const double w2 = 221899.946 * map_stiffness(r);
        assert_close(map.theory[r], (sqrt(200 * 200 + 4 * w2) - 200) / w2, 1e-4);
        assert_near(map_position(&map, map_step(&map, r)), r, 1e-9);
    }
    map_end(&map);
    world_close(&world);
}

static void the_scenes_own_row_comes_first(void** state) {
    (void)state;
    World world;
    Map map;
    WORLD_OF(&world, "limit-springs");
    map_begin(&map, &world, NULL, 0);
    while (map.rows_done == 0 && map_work(&map))
        ;
    for (int r = 0; r < MAP_ROWS; r++)
        for (int c = 0; c < MAP_COLUMNS; c++)
            assert_true((map.cell[r][c] == MAP_UNKNOWN) == (r != MAP_OWN_ROW));
    map_work(&map);
    map_end(&map); // in the middle of a row
    world_close(&world);
}

static void a_cells_scene_has_its_step_and_stiffness(void** state) {
    (void)state;
    World world, watched;
    WorldDef def;
    Fault fault = {0};
    const SceneSet own[] = {{"balloons.0.inflation.amount=7"}};
    assert_true(scene_load("tether", own, 1, &def, &fault));
    assert_true(world_open(&world, &def, &fault));
    Map map;
    MapSets sets;
    map_begin(&map, &world, own, 1);
    map_sets(&map, MAP_OWN_ROW + 2, MAP_OWN_COLUMN - 4, &sets);
    assert_true(scene_load("tether", sets.set, sets.count, &def, &fault));
    assert_true(world_open(&watched, &def, &fault));
    assert_close(watched.step, world.step / 4, 1e-12);
    assert_int_equal(watched.def.guard, GUARD_OFF);
    assert_close(watched.def.balloons[0].inflation->amount, 7.0, 1e-12);
    const SpringsDef *springs = watched.def.balloons[0].skin.springs,
                     *before = world.def.balloons[0].skin.springs;
    assert_close(springs->structural, 4 * before->structural, 1e-12);
    assert_close(springs->shear, 4 * before->shear, 1e-12);
    assert_close(springs->flexion, 4 * before->flexion, 1e-12);

    // the map belongs to the scene, also if the world is that of a cell
    Map other;
    map_begin(&other, &watched, own, 1);
    assert_true(map_step(&other, 0) == map_step(&map, 0));
    map_end(&other);
    map_end(&map);
    world_close(&watched);
    world_close(&world);
}

/// Above the maximum of its pressure rubber has no rest; and every step of newton is stable.
static void where_there_is_no_map_it_says_why(void** state) {
    (void)state;
    World world;
    Map map;
    WORLD_OF(&world, "limit-rubber", "balloons.0.inflation.amount=1300", "guard='off'");
    world_step(&world);
    const SceneSet set[] = {{"balloons.0.inflation.amount=1300"}};
    map_begin(&map, &world, set, 1);
    measure(&map);
    assert_non_null(strstr(map.why, "does not come to rest"));
    assert_int_equal(map.cell[MAP_OWN_ROW][0], MAP_UNKNOWN);
    map_end(&map);
    world_close(&world);

    WORLD_OF(&world, "grid:4x4");
    map_begin(&map, &world, NULL, 0);
    assert_int_equal(measure(&map), 0);
    assert_non_null(strstr(map.why, "an open skin"));
    map_end(&map);
    world_close(&world);

    WORLD_OF(&world, "teddy");
    map_begin(&map, &world, NULL, 0);
    assert_int_equal(measure(&map), 0);
    assert_non_null(strstr(map.why, "newton: no map"));
    map_end(&map);
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_are_stable_below_the_limit_and_not_above),
        cmocka_unit_test(theory_is_that_of_the_stiffened_skin),
        cmocka_unit_test(the_scenes_own_row_comes_first),
        cmocka_unit_test(a_cells_scene_has_its_step_and_stiffness),
        cmocka_unit_test(where_there_is_no_map_it_says_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
