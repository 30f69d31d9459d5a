/// The lab's page: it shows what was measured and when, and changes no bit of the world.
#include "worlds.h"

#include "show/lab_page.h"

enum { EVERY = 4 }; ///< steps between two points

static void step(LabPage* lab, World* world, int count) {
    for (int n = 0; n < count; n++) {
        world_step(world);
        lab_page_step(lab, world, EVERY);
    }
}

static const PagePlot* plot(const Page* page, const char* label) {
    for (int k = 0; k < page->plot_count; k++)
        if (strcmp(page->plot[k].label, label) == 0)
            return &page->plot[k];
    return NULL;
}

static void a_plot_holds_what_the_csv_says(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "tether");
    LabPage* lab = lab_page_open(false);
    float want[3][10];
    for (int k = 0; k < 10; k++) {
        step(lab, &world, k == 0 ? 1 : EVERY);
        want[0][k] = (float)probe(&world, "balloon0.volume");
        want[1][k] = (float)probe(&world, "balloon0.gauge_pressure");
        want[2][k] = (float)probe(&world, "balloon0.total_energy");
    }
    const Page* page = lab_page_take(lab, &world);
    assert_int_equal(page->count, 10);
    const char* label[] = {"volume", "pressure", "energy"};
    for (int q = 0; q < 3; q++)
        assert_memory_equal(plot(page, label[q])->y, want[q], sizeof want[q]);
    for (int k = 0; k < 10; k++)
        assert_near(page->t[k], (1 + EVERY * k) * world.step, 1e-6);
    lab_page_close(lab);
    world_close(&world);
}

static void the_oldest_points_make_room(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "cube");
    LabPage* lab = lab_page_open(false);
    step(lab, &world, EVERY * (PAGE_POINTS + 7));
    const Page* page = lab_page_take(lab, &world);
    assert_int_equal(page->count, PAGE_POINTS);
    for (int k = 1; k < page->count; k++)
        assert_near(page->t[k] - page->t[k - 1], EVERY * world.step, 1e-6);
    assert_near(page->t[0], (1 + EVERY * 7) * world.step, 1e-6);
    lab_page_close(lab);
    world_close(&world);
}

/// A reset turns the time back, and another balloon has other numbers.
static void a_reset_and_another_balloon_begin_it_again(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "two-joined");
    LabPage* lab = lab_page_open(false);
    step(lab, &world, 10 * EVERY);
    world_reset(&world);
    step(lab, &world, 1);
    assert_int_equal(lab_page_take(lab, &world)->count, 1);

    step(lab, &world, 10 * EVERY);
    press(&world, "select", "down");
    press(&world, "select", "down");
    step(lab, &world, 1);
    const Page* page = lab_page_take(lab, &world);
    assert_int_equal(page->count, 1);
    assert_string_equal(page->title, "Balloon 1");
    assert_true(plot(page, "volume")->y[0] == (float)probe(&world, "balloon1.volume"));
    lab_page_close(lab);
    world_close(&world);
}

static void what_a_balloon_has_not_is_not_plotted(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "grid:4x4"); // open
    for (int timed = 0; timed < 2; timed++) {
        LabPage* lab = lab_page_open(timed);
        lab_page_start(lab);
        assert_int_equal(lab_page_take(lab, &world)->plot_count, 0);
        step(lab, &world, 2 * EVERY);
        const Page* page = lab_page_take(lab, &world);
        assert_null(plot(page, "volume"));
        assert_non_null(plot(page, "pressure"));
        assert_true((plot(page, "a step") != NULL) == timed);
        if (timed)
            assert_true(plot(page, "a step")->y[1] > 0);
        lab_page_close(lab);
    }
    world_close(&world);
}

static void the_page_changes_no_bit_of_the_world(void** state) {
    (void)state;
    World watched, alone;
    WORLD_OF(&watched, "party");
    WORLD_OF(&alone, "party");
    LabPage* lab = lab_page_open(true);
    lab_page_start(lab);
    for (int n = 0; n < 50; n++) {
        step(lab, &watched, 1);
        lab_page_take(lab, &watched);
        world_step(&alone);
    }
    assert_true(world_hash(&watched) == world_hash(&alone));
    lab_page_close(lab);
    world_close(&watched);
    world_close(&alone);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plot_holds_what_the_csv_says),
        cmocka_unit_test(the_oldest_points_make_room),
        cmocka_unit_test(a_reset_and_another_balloon_begin_it_again),
        cmocka_unit_test(what_a_balloon_has_not_is_not_plotted),
        cmocka_unit_test(the_page_changes_no_bit_of_the_world),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
