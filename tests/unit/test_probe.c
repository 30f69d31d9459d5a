/// Outputs: the columns of a CSV follow from the scene, and have the described values.
#include "force/force.h"
#include "world/outputs.h"
#include "worlds.h"

static const char* const two_balls =
    "spheres=[{position: [3, 1, 0.5], velocity: [-1, 0.25, 2], radius: 0.5, mass: 1}, "
    "{position: [-3, 1, 0], radius: 0.5, mass: 1}]";

/// The CSV's header and first row, as the program writes them.
static void csv(const World* world, char text[8192]) {
    FILE* out = tmpfile();
    probe_csv_header(world, out);
    fputc('\n', out);
    probe_csv_row(world, out);
    fputc('\n', out);
    rewind(out);
    text[fread(text, 1, 8191, out)] = 0;
    fclose(out);
}

static int commas(const char* line) {
    int count = 0;
    for (; *line && *line != '\n'; line++)
        count += *line == ',';
    return count;
}

static void each_name_has_a_number(void** state) {
    (void)state;
    static const char* const scene[] = {"tether", "grid:6x6", "party"};
    for (size_t s = 0; s < sizeof scene / sizeof *scene; s++) {
        World world;
        char text[8192];
        WORLD_OF(&world, scene[s], two_balls);
        csv(&world, text);
        const char* row = strchr(text, '\n') + 1;
        assert_int_equal(commas(text), commas(row));
        assert_true(strncmp(text, "t,balloon0.", 11) == 0);
        world_close(&world);
    }
}

static void balls_of_the_scene_have_columns_in_order(void** state) {
    (void)state;
    World world;
    char text[8192];
    WORLD_OF(&world, "tether", two_balls);
    csv(&world, text);
    const char* want = ",sphere0.x,sphere0.y,sphere0.z,sphere0.vx,sphere0.vy,sphere0.vz,"
                       "sphere0.fx,sphere0.fy,sphere0.fz,"
                       "sphere1.x,sphere1.y,sphere1.z,sphere1.vx,sphere1.vy,sphere1.vz,"
                       "sphere1.fx,sphere1.fy,sphere1.fz,"
                       "pass_throughs,floor.force,guard.taken_back\n";
    const char* row = strchr(text, '\n') + 1;
    assert_int_equal(strncmp(row - strlen(want), want, strlen(want)), 0);

    const char* numbers = ",3,1,0.5,-1,0.25,2,0,0,0,-3,1,0,0,0,0,0,0,0,0,0,0\n";
    assert_string_equal(text + strlen(text) - strlen(numbers), numbers);
    world_close(&world);
}

static void throw_one(World* world) {
    const Event event = {
        .step = world->clock, .kind = EVENT_THROW, .thrown = {0.5, 4, 0, 0, 1, 0, 1, 0.25}};
    Fault fault = {0};
    assert_true(world_event(world, &event, &fault));
}

/// The CSV's columns are those of the scene; a query by name finds thrown balls too.
static void thrown_balls_have_values_and_no_columns(void** state) {
    (void)state;
    World world;
    char before[8192], after[8192];
    double value;
    WORLD_OF(&world, "tether");
    csv(&world, before);
    assert_null(strstr(before, "sphere"));
    assert_null(strstr(before, "pass_throughs"));
    assert_false(probe_value(&world, "pass_throughs", &value));
    throw_one(&world);
    csv(&world, after);
    assert_string_equal(after, before);
    assert_near(probe(&world, "sphere0.x"), 0.5, 0);
    assert_near(probe(&world, "sphere0.vy"), 1, 0);
    assert_near(probe(&world, "pass_throughs"), 0, 0);
    world_close(&world);
}

static void a_ball_that_was_taken_away_is_nowhere(void** state) {
    (void)state;
    World world;
    char before[8192], after[8192];
    WORLD_OF(&world, "tether", two_balls);
    csv(&world, before);
    press(&world, "clear", "down");
    csv(&world, after);
    const size_t names = strcspn(before, "\n");
    assert_memory_equal(before, after, names);
    assert_true(isnan(probe(&world, "sphere0.x")) && isnan(probe(&world, "sphere1.vz")));
    assert_near(probe(&world, "pass_throughs"), 0, 0);
    throw_one(&world); // the first ball of the world
    assert_near(probe(&world, "sphere0.x"), 0.5, 0);
    assert_true(isnan(probe(&world, "sphere1.x")));
    world_close(&world);
}

/// `iterations` and `residual` are columns of the methods that iterate, `products` of those that
/// multiply, and of no others. Statistics without a column stay 0.
static void methods_report_the_statistics_of_their_row(void** state) {
    (void)state;
    for (int m = 0; m < method_count; m++) {
        World world;
        char text[8192], method[64];
        snprintf(method, sizeof method, "method=%s", method_table[m]->name);
        WORLD_OF(&world, "tether", method);
        csv(&world, text);
        text[strcspn(text, "\n")] = 0;
        const bool iterates = method_table[m]->iterates, multiplies = method_table[m]->multiplies;
        assert_int_equal(strstr(text, "iterations") != NULL, iterates);
        assert_int_equal(strstr(text, "residual") != NULL, iterates);
        assert_int_equal(strstr(text, "products") != NULL, multiplies);
        world_step(&world);
        assert_int_equal(world.balloon[0].stats.iterations > 0, iterates);
        assert_int_equal(world.balloon[0].stats.products > 0, multiplies);
        world_close(&world);
    }
}

/// Every row has a name, a unit and a sentence, and no kind has two columns of one name.
static void every_output_has_a_unit_and_a_sentence(void** state) {
    (void)state;
    for (int k = 0; k < output_count; k++) {
        const Output* output = &output_table[k];
        assert_true(output->column[0] && output->unit[0] && output->about[0]);
        assert_int_equal(output->of_balloon != NULL, output->kind == OF_BALLOON);
        assert_int_equal(output->value != NULL, output->kind != OF_BALLOON);
        for (int other = 0; other < k; other++)
            assert_false(output_table[other].kind == output->kind &&
                         strcmp(output_table[other].column, output->column) == 0);
    }
}

/// `elastic` is the sum over all rows with that property.
static void elastic_energy_is_that_of_the_rows_that_say_so(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "tether");
    run_for(&world, 0.1);
    double sum = 0;
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->elastic && force_table[k]->present(&world.balloon[0].body))
            sum += force_table[k]->energy(&world.balloon[0].body);
    assert_true(sum > 0);
    assert_near(probe(&world, "balloon0.elastic"), sum, 0);
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_name_has_a_number),
        cmocka_unit_test(balls_of_the_scene_have_columns_in_order),
        cmocka_unit_test(thrown_balls_have_values_and_no_columns),
        cmocka_unit_test(a_ball_that_was_taken_away_is_nowhere),
        cmocka_unit_test(methods_report_the_statistics_of_their_row),
        cmocka_unit_test(every_output_has_a_unit_and_a_sentence),
        cmocka_unit_test(elastic_energy_is_that_of_the_rows_that_say_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
