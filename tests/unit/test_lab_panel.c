/// The lab panel shows measurements and their times, and changes no bit of the world.
#include "worlds.h"

#include "show/live_lab.h"

enum { EVERY = 4 }; ///< steps between two points

static void step(LiveLab* lab, World* world, int count) {
    for (int n = 0; n < count; n++) {
        world_step(world);
        live_lab_step(lab, world, EVERY, 0);
    }
}

static const LabPlot* plot(const LabPanel* panel, const char* label) {
    for (int k = 0; k < panel->plot_count; k++)
        if (strcmp(panel->plot[k].label, label) == 0)
            return &panel->plot[k];
    return NULL;
}

static void a_plot_holds_what_the_csv_says(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "tether");
    LiveLab* lab = live_lab_open(&world, NULL, 0, false);
    float want[3][10];
    live_lab_start(lab, &world);
    for (int k = 0; k < 10; k++) {
        step(lab, &world, k == 0 ? 0 : EVERY);
        want[0][k] = (float)probe(&world, "balloon0.volume");
        want[1][k] = (float)probe(&world, "balloon0.gauge_pressure");
        want[2][k] = (float)probe(&world, "balloon0.total_energy");
    }
    const LabPanel* panel = live_lab_update(lab, &world, false, 0);
    assert_int_equal(panel->count, 10);
    const char* label[] = {"volume", "pressure", "energy"};
    for (int q = 0; q < 3; q++)
        assert_memory_equal(plot(panel, label[q])->y, want[q], sizeof want[q]);
    for (int k = 0; k < 10; k++)
        assert_near(panel->t[k], EVERY * k * world.step, 1e-6);
    live_lab_close(lab);
    world_close(&world);
}

static void the_oldest_points_make_room(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "cube");
    LiveLab* lab = live_lab_open(&world, NULL, 0, false);
    live_lab_start(lab, &world);
    step(lab, &world, EVERY * (LAB_POINTS + 6));
    const LabPanel* panel = live_lab_update(lab, &world, false, 0);
    assert_int_equal(panel->count, LAB_POINTS);
    for (int k = 1; k < panel->count; k++)
        assert_near(panel->t[k] - panel->t[k - 1], EVERY * world.step, 1e-6);
    assert_near(panel->t[0], EVERY * 7 * world.step, 1e-6);
    live_lab_close(lab);
    world_close(&world);
}

/// A reset sets the time to 0, and another balloon has other measurements: the plots begin anew.
static void a_reset_and_another_balloon_begin_it_again(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "two-joined");
    LiveLab* lab = live_lab_open(&world, NULL, 0, false);
    step(lab, &world, 10 * EVERY);
    world_reset(&world);
    step(lab, &world, 1);
    assert_int_equal(live_lab_update(lab, &world, false, 0)->count, 1);

    step(lab, &world, 10 * EVERY);
    press(&world, "select", "down");
    press(&world, "select", "down");
    step(lab, &world, 1);
    const LabPanel* panel = live_lab_update(lab, &world, false, 0);
    assert_int_equal(panel->count, 1);
    assert_string_equal(panel->title, "Balloon 1");
    assert_true(plot(panel, "volume")->y[0] == (float)probe(&world, "balloon1.volume"));
    live_lab_close(lab);
    world_close(&world);
}

static void what_a_balloon_has_not_is_not_plotted(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "grid:4x4"); // open
    for (int timed = 0; timed < 2; timed++) {
        LiveLab* lab = live_lab_open(&world, NULL, 0, timed);
        live_lab_start(lab, &world);
        step(lab, &world, 2 * EVERY);
        const LabPanel* panel = live_lab_update(lab, &world, false, 0);
        assert_null(plot(panel, "volume"));
        assert_non_null(plot(panel, "pressure"));
        assert_true((plot(panel, "step cost") != NULL) == timed);
        if (timed)
            assert_true(plot(panel, "step cost")->y[1] > 0);
        live_lab_close(lab);
    }
    world_close(&world);
}

/// truth: a round skin of rubber, R0 = 0.1 m, has 1185.797827 Pa at l = 1.2550441340, and its mesh
/// of 162 points this volume; springs of 50/10/10 that are blown up by the area law grow by
/// 0.036172.
static void a_round_skin_has_its_closed_form(void** state) {
    (void)state;
    World world;
    Spherical round;
    WORLD_OF(&world, "sphere-gas");
    assert_true(spherical_find(&world.balloon[0], &round));
    assert_close(truth_pressure(&round.truth, 1.2550441340), 1185.797827, 1e-6);
    assert_close(round.volume, 0.00404704467997885, TOLERANCE(1e-6, 1e-12));
    world_close(&world);

    WORLD_OF(&world, "tether", "balloons.0.model=cube-sphere:4");
    assert_true(spherical_find(&world.balloon[0], &round));
    const double l = 1.036172;
    assert_close(truth_pressure(&round.truth, l), 100 / (4 * PI * l * l), 1e-4);
    world_close(&world);
}

static void other_skins_have_none(void** state) {
    (void)state;
    const char* const* const none[] = {
        (const char* const[]){"squirrel-turns", NULL},
        (const char* const[]){"torus:24x12", NULL},
        (const char* const[]){"exact-cube", NULL},
        (const char* const[]){"grid:4x4", NULL},
        (const char* const[]){
            "peak",
            "balloons.0.skin.membrane.patches=[{at: [0, -0.1, 0], radius: 0.1, thickness: 1e-4}]",
            NULL},
        (const char* const[]){"tether", "balloons.0.model=icosphere:2", NULL},
        (const char* const[]){"tether", "balloons.0.skin.springs.law=tension", NULL},
    };
    for (size_t k = 0; k < sizeof none / sizeof *none; k++) {
        World world;
        Spherical round;
        world_of_list(&world, none[k]);
        if (spherical_find(&world.balloon[0], &round))
            fail_msg("%s has a closed form", none[k][0]);
        LiveLab* lab = live_lab_open(&world, NULL, 0, false);
        live_lab_start(lab, &world);
        assert_false(live_lab_update(lab, &world, false, 0)->has_curve);
        live_lab_close(lab);
        world_close(&world);
    }
}

/// Twice as wide: on this mesh the pressure at rest is within 2 % of rubber's.
static void the_dot_ends_on_the_curve(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "sphere-curve");
    LiveLab* lab = live_lab_open(&world, NULL, 0, false);
    live_lab_start(lab, &world);
    while (world_time(&world) < 0.4) {
        world_step(&world);
        live_lab_step(lab, &world, 1, 0);
    }
    const LabPanel* panel = live_lab_update(lab, &world, false, 0);
    assert_true(panel->has_curve);
    const LabCurve* curve = &panel->curve;
    const float* now = curve->path[curve->count - 1];
    assert_near(curve->path[0][0], 1, 1e-6);
    assert_near(curve->path[0][1], 0, 0.1);
    assert_close(now[0], 2.0, 0.01);
    const double part = (now[0] - 1) / (curve->stretch - 1) * (LAB_CURVE - 1);
    assert_true(part >= 0 && part <= LAB_CURVE - 1);
    assert_close(now[1], curve->truth[lround(part)], 0.02);
    live_lab_close(lab);
    world_close(&world);
}

/// The program was delayed in one step of twenty: the plot still shows the others.
static void a_cost_far_above_the_rest_is_cut(void** state) {
    (void)state;
    World world;
    static History history;
    static LabPanel panel;
    WORLD_OF(&world, "cube");
    history_begin(&history);
    for (int k = 0; k < 20; k++) {
        history_add(&history, &world, k == 7 ? 50 : k % 2 + 1);
        world_step(&world);
    }
    history_plot(&history, &panel);
    const LabPlot* cost = plot(&panel, "step cost");
    for (int k = 0; k < 20; k++)
        assert_near(cost->y[k], k == 7 ? 8 : k % 2 + 1, 1e-6);
    world_close(&world);
}

static void the_panel_changes_no_bit_of_the_world(void** state) {
    (void)state;
    World watched, alone;
    WORLD_OF(&watched, "party");
    WORLD_OF(&alone, "party");
    LiveLab* lab = live_lab_open(&watched, NULL, 0, true);
    live_lab_start(lab, &watched);
    for (int n = 0; n < 50; n++) {
        step(lab, &watched, 1);
        live_lab_update(lab, &watched, false, 0);
        world_step(&alone);
    }
    assert_true(world_hash(&watched) == world_hash(&alone));
    live_lab_close(lab);
    world_close(&watched);
    world_close(&alone);
}

/// For a scene without measured advice the slider says how to measure; otherwise it shows the
/// promise of the notch and, after the outputs' times, their errors.
static void a_slider_says_what_is_known(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "exact-cube");
    AdvicePoint point[2] = {{.method = "euler", .step = 1e-3, .error = 0.1, .ms = 0.5},
                            {.method = "euler", .step = 1e-4, .error = 0.01, .ms = 5}};
    const AdvicePoint* front[2] = {&point[0], &point[1]};
    Slider slider = {.error = (double)NAN};
    LabSlider panel = {0};
    slider_fill(&slider, &world, 0, false, &panel);
    assert_int_equal(panel.notches, 0);
    assert_non_null(strstr(panel.line[1], "balloon advise"));

    slider = (Slider){.front = front, .notches = 2, .error = (double)NAN};
    slider.advice.outputs = 1;
    slider.advice.reference[0] = 1;
    slider_fill(&slider, &world, 2, false, &panel);
    assert_int_equal(panel.notch, 2);
    assert_non_null(strstr(panel.line[1], "5 ms a frame"));
    assert_non_null(strstr(panel.line[2], "not yet known"));

    assert_true(scene_outputs(&world.def) > 0);
    double value = 0;
    while (world_time(&world) < world.def.about[0].at - world.step / 2) {
        world_step(&world);
        slider_step(&slider, &world, 1);
    }
    assert_true(probe_value(&world, world.def.about[0].output, &value));
    assert_near(slider.error, fabs(value - 1), 1e-12);
    slider_fill(&slider, &world, 0, true, &panel);
    assert_non_null(strstr(panel.line[1], "as it is"));
    assert_non_null(strstr(panel.line[2], "% off"));
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slider_says_what_is_known),
        cmocka_unit_test(a_plot_holds_what_the_csv_says),
        cmocka_unit_test(the_oldest_points_make_room),
        cmocka_unit_test(a_reset_and_another_balloon_begin_it_again),
        cmocka_unit_test(what_a_balloon_has_not_is_not_plotted),
        cmocka_unit_test(a_round_skin_has_its_closed_form),
        cmocka_unit_test(other_skins_have_none),
        cmocka_unit_test(the_dot_ends_on_the_curve),
        cmocka_unit_test(a_cost_far_above_the_rest_is_cut),
        cmocka_unit_test(the_panel_changes_no_bit_of_the_world),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
