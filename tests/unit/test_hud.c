/// The overlay: the status box and the lab panel.
#include "drawn.h"
#include "hud/hud.h"

static void the_overlay_says_the_same_twice_and_stays_in_its_corner(void** state) {
    (void)state;
    Fault fault = {0};
    assert_true(hud_open(1, &fault));
    Overlay overlay = {.status_visible = true, .title = "title"};
    overlay_row(&overlay, "label", "%d", 42);
    Pixels* both[2] = {&pixels, &others};
    for (int i = 0; i < 2; i++) {
        renderer_draw(renderer, &drawn.picture);
        hud_draw(&overlay, WIDTH, HEIGHT);
        renderer_read(renderer, (*both[i])[0][0]);
    }
    assert_memory_equal(pixels, others, sizeof pixels);

    draw(others);
    assert_memory_not_equal(pixels[20], others[20], sizeof pixels[20]);
    assert_memory_equal(pixels[HEIGHT - 1], others[HEIGHT - 1], sizeof pixels[0]);
    hud_close();
}

enum { WIDE = 1280, HIGH = 720 }; // where a panel has room
static unsigned char large[2][HIGH][WIDE][3];

/// The panel is on the right of the picture, its slider on the lower left; a rising curve is drawn
/// rising.
static void the_lab_panel_draws_its_plots_on_the_right(void** state) {
    (void)state;
    Fault fault = {0};
    assert_true(hud_open(1, &fault));
    renderer_resize(renderer, WIDE, HIGH);
    static LabPanel panel = {.title = "Balloon 0", .count = 2, .t = {0, 1}, .plot_count = 1};
    panel.map.method = "euler";
    panel.plot[0] = (LabPlot){.label = "volume", .value = "2", .y = {1, 2}};
    const Overlay overlay = {.lab_panel = &panel};
    const int left = 954, center = 1104, top = 69, middle = 90, low = 111; // of hud/lab_panel.cpp
    int bright[2][2] = {{0}}; // in the left half of the plot, above and below its middle
    for (int i = 0; i < 2; i++) {
        panel.plot[0].y[1 - i] = 1;
        panel.plot[0].y[i] = 2;
        renderer_draw(renderer, &drawn.picture);
        hud_draw(&overlay, WIDE, HIGH);
        renderer_read(renderer, large[i][0][0]);
        for (int y = top; y < low; y++)
            for (int x = left; x < center; x++)
                bright[i][y >= middle] += brightness(large[i][y][x]) > 400;
    }
    assert_true(bright[1][1] > bright[1][0]); // rising
    assert_true(bright[0][0] > bright[0][1]); // falling

    renderer_draw(renderer, &drawn.picture);
    renderer_read(renderer, large[0][0][0]);
    for (int y = 0; y < 640; y++)
        assert_memory_equal(large[0][y], large[1][y], 3 * 940);
    hud_close();
}

/// In a narrow picture the status box has more lines, and neither the panel nor the keys cover any
/// of them.
static void the_status_box_gives_way(void** state) {
    (void)state;
    Fault fault = {0};
    assert_true(hud_open(1, &fault));
    static LabPanel panel = {.title = "Balloon 0", .map.method = "euler"};
    static Overlay overlay = {.title = "a title", .lab_panel = &panel};
    overlay_row(&overlay, "balloon 0",
                "amount 1, pressure 7.428, volume x 1.12, and more than that");
    overlay.key[overlay.key_count++] =
        (OverlayKey){"key", "what a key does, in so many words as these"};
    for (int width = 500; width <= 640; width += 140)
        for (int help = 0; help < 2; help++) {
            overlay.help_visible = help;
            renderer_resize(renderer, width, HEIGHT);
            for (int on = 0; on < 2; on++) {
                overlay.status_visible = on;
                renderer_draw(renderer, &drawn.picture);
                hud_draw(&overlay, width, HEIGHT);
                renderer_read(renderer, large[on][0][0]);
            }
            // of hud/lab_panel.cpp; the box of the keys is a little wider than its column
            const int left = help ? width - 14 - 24 - 7 * 48 : width - 26 - 12 - 2 * width / 5;
            int before = 0, beyond = 0;
            const unsigned char* off = large[0][0][0];
            const unsigned char* on = large[1][0][0];
            for (int i = 0; i < 3 * width * HEIGHT; i++)
                *(i / 3 % width < left ? &before : &beyond) += off[i] != on[i];
            assert_int_equal(beyond, 0);
            assert_true(help || before > 3000);
        }
    hud_close();
}

/// A click selects the cell or notch that is drawn at its position.
static void a_cell_of_the_map_is_found_where_it_is_drawn(void** state) {
    (void)state;
    Fault fault = {0};
    assert_true(hud_open(1, &fault));
    renderer_resize(renderer, WIDE, HIGH);
    static LabPanel panel = {.map.method = "euler"};
    Overlay overlay = {.lab_panel = &panel};
    const int lit[][2] = {{0, 0}, {4, 6}, {LAB_ROWS - 1, LAB_COLUMNS - 1}};
    for (int k = 0; k < 3; k++) {
        LabCell* cell = &panel.map.cell[lit[k][0]][lit[k][1]];
        for (int on = 0; on < 2; on++) {
            *cell = on ? LAB_EXPLODED : LAB_UNKNOWN;
            renderer_draw(renderer, &drawn.picture);
            hud_draw(&overlay, WIDE, HIGH);
            renderer_read(renderer, large[on][0][0]);
        }
        *cell = LAB_UNKNOWN;
        int found = 0, painted = 0, both = 0;
        for (int y = 0; y < HIGH; y++)
            for (int x = 0; x < WIDE; x++) {
                const float at[2] = {((float)x + 0.5f) / WIDE, ((float)y + 0.5f) / HIGH};
                int got[2] = {-1, -1};
                const bool in = hud_cell(&overlay, WIDE, HIGH, at, got) && got[0] == lit[k][0] &&
                                got[1] == lit[k][1];
                const bool red = memcmp(large[0][y][x], large[1][y][x], 3) != 0;
                found += in;
                painted += red;
                both += in && red;
            }
        assert_true(painted > 50 && both == painted && painted > found * 7 / 10);
    }
    overlay.help_visible = true;
    assert_false(hud_cell(&overlay, WIDE, HIGH, (const float[]){0.85f, 0.1f}, (int[2]){0}));
    hud_close();
}

static void a_panel_takes_no_more_rows_than_it_has(void** state) {
    (void)state;
    static Overlay overlay;
    for (int i = 0; i < 2 * OVERLAY_ROWS; i++)
        overlay_row(&overlay, "a label that is longer than the room for it is", "%0200d", i);
    assert_int_equal(overlay.row_count, OVERLAY_ROWS);
    assert_int_equal(strlen(overlay.row[0].value), OVERLAY_TEXT - 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(the_overlay_says_the_same_twice_and_stays_in_its_corner, set_up),
        cmocka_unit_test_setup(the_lab_panel_draws_its_plots_on_the_right, set_up),
        cmocka_unit_test_setup(the_status_box_gives_way, set_up),
        cmocka_unit_test_setup(a_cell_of_the_map_is_found_where_it_is_drawn, set_up),
        cmocka_unit_test(a_panel_takes_no_more_rows_than_it_has),
    };
    return cmocka_run_group_tests(tests, open_all, close_all);
}
