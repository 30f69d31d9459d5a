// Pictures drawn without a window: what is where, what covers what, and that nothing depends on
// what was drawn before.
#include "law.h"

#include "base/memory.h"
#include "draw/depth.h"
#include "draw/egl.h"
#include "draw/renderer.h"
#include "draw/shadow.h"
#include "hud/hud.h"

enum { WIDTH = 160, HEIGHT = 120, RINGS = 16, SPOKES = 24 };
enum { POINTS = (RINGS + 1) * SPOKES, TRIANGLES = 2 * RINGS * SPOKES };

/// A ball of rubber over a floor, and all that a picture of it points to.
typedef struct Studio {
    float position[POINTS][3], normal[POINTS][3], tint[POINTS][3], stretch[POINTS];
    int triangle[TRIANGLES][3];
    PictureSkin skin;
    PictureLine line[1];
    PictureBall ball[1];
    Picture picture;
} Studio;

typedef unsigned char Pixels[HEIGHT][WIDTH][3];

static Egl egl;
static Renderer* renderer;
static Studio studio;
static Pixels pixels, others;

// A sphere of rings from pole to pole, wound counter-clockwise from outside.
static void blow_up(float radius, float height) {
    for (int i = 0; i < POINTS; i++) {
        const float down = 3.14159265f * (float)(i / SPOKES) / RINGS;
        const float round = 6.2831853f * (float)(i % SPOKES) / SPOKES;
        const float n[3] = {sinf(down) * sinf(round), cosf(down), sinf(down) * cosf(round)};
        for (int k = 0; k < 3; k++) {
            studio.normal[i][k] = n[k];
            studio.position[i][k] = radius * n[k] + (k == 1 ? height : 0);
            studio.tint[i][k] = k == 2 ? 0.9f : 0.05f;
        }
        studio.stretch[i] = 1;
    }
    for (int i = 0; i < RINGS * SPOKES; i++) {
        const int ring = i / SPOKES * SPOKES, next = ring + (i + 1) % SPOKES;
        const int quad[4] = {ring + i % SPOKES, ring + i % SPOKES + SPOKES, next + SPOKES, next};
        for (int k = 0; k < 3; k++) {
            studio.triangle[2 * i][k] = quad[k];
            studio.triangle[2 * i + 1][k] = quad[(k + 2) % 4];
        }
    }
}

// A red balloon of radius 1 at height 2; nothing else but the floor.
static int set_up(void** state) {
    (void)state;
    blow_up(1, 2);
    studio.skin = (PictureSkin){.point_count = POINTS,
                                .triangle_count = TRIANGLES,
                                .triangle = (const int(*)[3])studio.triangle,
                                .position = studio.position,
                                .normal = studio.normal,
                                .stretch = studio.stretch,
                                .tint = studio.tint,
                                .color = {0.7f, 0.02f, 0.02f}};
    studio.picture =
        (Picture){.skin_count = 1,
                  .skin = &studio.skin,
                  .line = studio.line,
                  .line_room = 1,
                  .ball = studio.ball,
                  .ball_room = 1,
                  .floor = true,
                  .scene_center = {0, 2, 0},
                  .scene_radius = 1.8f,
                  .camera = {.target = {0, 2, 0}, .distance = 9, .pitch = 0.35f, .field = 0.6f}};
    renderer_resize(renderer, WIDTH, HEIGHT);
    return 0;
}

static void draw(Pixels into) {
    renderer_draw(renderer, &studio.picture);
    renderer_read(renderer, into[0][0]);
}

static bool is_red(const unsigned char rgb[3]) {
    return rgb[0] > 1.6 * rgb[1] && rgb[0] > 1.6 * rgb[2];
}

static bool is_blue(const unsigned char rgb[3]) {
    return rgb[2] > 1.6 * rgb[0] && rgb[2] > 1.6 * rgb[1];
}

static int red_pixels(void) {
    int count = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            count += is_red(pixels[y][x]);
    return count;
}

static int brightness(const unsigned char rgb[3]) {
    return rgb[0] + rgb[1] + rgb[2];
}

static void a_balloon_is_in_the_middle_of_a_pale_studio(void** state) {
    (void)state;
    draw(pixels);
    assert_true(is_red(pixels[HEIGHT / 2][WIDTH / 2]));
    const unsigned char* corner[] = {pixels[0][0], pixels[0][WIDTH - 1], pixels[HEIGHT - 1][0],
                                     pixels[HEIGHT - 1][WIDTH - 1]};
    for (int i = 0; i < 4; i++) {
        assert_false(is_red(corner[i]));
        assert_less(450, brightness(corner[i]));
    }
}

static void a_balloon_covers_what_its_radius_says(void** state) {
    (void)state;
    // seen from far away a sphere is a disc of half-angle asin(r/d)
    for (int i = 1; i <= 3; i++) {
        const float radius = 0.4f * (float)i;
        blow_up(radius, 2);
        draw(pixels);
        const double pixel = 2 * tan(0.3) / HEIGHT, slope = tan(asin(radius / 9));
        // its shine and its rim, which the studio shows through, are not red
        assert_close(red_pixels(), 3.14159265 * pow(slope / pixel, 2), 0.15);
    }
}

static void same_bytes(void) {
    assert_memory_equal(pixels, others, sizeof pixels);
}

static void other_bytes(void) {
    assert_memory_not_equal(pixels, others, sizeof pixels);
}

/// What the stamp spares is not seen: from elsewhere and back, and with another stamp.
static void a_stamp_changes_nothing_of_what_is_drawn(void** state) {
    (void)state;
    draw(others);
    studio.picture.stamp = 1;
    const float turns[] = {0, 0, 0.5f, 0};
    for (int k = 0; k < 4; k++) {
        studio.picture.camera.yaw = turns[k];
        draw(pixels);
        (turns[k] == 0 ? same_bytes : other_bytes)();
    }
    blow_up(0.3f, 1);
    studio.picture.stamp = 2;
    draw(pixels);
    other_bytes();
}

static void the_same_picture_gives_the_same_bytes(void** state) {
    (void)state;
    draw(pixels);
    blow_up(0.3f, 1);
    draw(others);
    assert_memory_not_equal(pixels, others, sizeof pixels);
    blow_up(1, 2);
    draw(others);
    assert_memory_equal(pixels, others, sizeof pixels);
}

static void a_size_drawn_before_another_leaves_no_trace(void** state) {
    (void)state;
    draw(pixels);
    renderer_resize(renderer, 37, 211);
    renderer_draw(renderer, &studio.picture);
    renderer_resize(renderer, WIDTH, HEIGHT);
    draw(others);
    assert_memory_equal(pixels, others, sizeof pixels);
}

static void stretched_rubber_is_paler(void** state) {
    (void)state;
    draw(pixels);
    const unsigned char* middle = pixels[HEIGHT / 2][WIDTH / 2];
    int last = middle[1] + middle[2];
    for (int s = 2; s <= 4; s++) {
        for (int i = 0; i < POINTS; i++)
            studio.stretch[i] = (float)s;
        draw(pixels);
        assert_less(last, middle[1] + middle[2]);
        last = middle[1] + middle[2];
    }
}

static void a_ball_behind_shows_only_through_stretched_rubber(void** state) {
    (void)state;
    const unsigned char* middle = pixels[HEIGHT / 2][WIDTH / 2];
    int change[2];
    for (int thin = 0; thin < 2; thin++) {
        for (int i = 0; i < POINTS; i++)
            studio.stretch[i] = thin ? 3 : 1;
        studio.picture.ball_count = 0;
        draw(pixels);
        const int without = brightness(middle);
        studio.ball[0] = (PictureBall){.center = {0, 2, 0}, .radius = 0.5f};
        studio.picture.ball_count = 1;
        draw(pixels);
        change[thin] = without - brightness(middle);
    }
    assert_less(change[0], 20);
    assert_less(60, change[1]);
}

static void a_field_is_drawn_in_its_own_colours(void** state) {
    (void)state;
    studio.skin.paint = PAINT_FIELD;
    draw(pixels);
    assert_true(is_blue(pixels[HEIGHT / 2][WIDTH / 2]));
}

static void a_line_on_the_skin_is_seen_in_front_and_not_behind(void** state) {
    (void)state;
    studio.skin.paint = PAINT_FIELD;
    studio.picture.camera.pitch = 0;
    for (int side = -1; side <= 1; side += 2) {
        const float z = (float)side;
        studio.line[0] = (PictureLine){
            .from = {-0.3f, 2, z}, .to = {0.3f, 2, z}, .color = {1, 0, 0}, .width = 24};
        studio.picture.line_count = 1;
        draw(pixels);
        assert_int_equal(is_red(pixels[HEIGHT / 2][WIDTH / 2]), side == 1);
    }
}

static void a_faint_shape_veils_a_line_within_and_hides_none(void** state) {
    (void)state;
    studio.skin.paint = PAINT_FAINT;
    studio.picture.camera.pitch = 0;
    studio.line[0] =
        (PictureLine){.from = {-0.3f, 2, 0}, .to = {0.3f, 2, 0}, .color = {0, 0, 1}, .width = 24};
    const unsigned char* middle = pixels[HEIGHT / 2][WIDTH / 2];
    draw(pixels);
    const int without = middle[0];
    studio.picture.line_count = 1;
    draw(pixels);
    const int within = middle[0];
    assert_less(within, without - 40);

    // in front of the shape the same line is drawn in full
    studio.line[0].from[2] = studio.line[0].to[2] = 1.1f;
    draw(pixels);
    assert_less(middle[0], within - 40);
    assert_true(is_blue(middle));
}

static void what_is_selected_glows_around_and_nowhere_else(void** state) {
    (void)state;
    draw(pixels);
    studio.skin.selected = true;
    draw(others);

    // the balloon's radius in pixels is 0.112 / 0.0052 = 21
    const int middle = HEIGHT / 2;
    assert_memory_equal(pixels[middle][WIDTH / 2], others[middle][WIDTH / 2], 3);
    assert_memory_equal(pixels[middle][0], others[middle][0], 3);
    assert_memory_not_equal(pixels[middle][WIDTH / 2 + 24], others[middle][WIDTH / 2 + 24], 3);
}

static void an_open_skin_shows_its_inside(void** state) {
    (void)state;
    // the rear half alone: seen from its inside
    int kept = 0;
    for (int i = 0; i < TRIANGLES; i++)
        if (studio.position[studio.triangle[i][0]][2] < -0.1f)
            memcpy(studio.triangle[kept++], studio.triangle[i], sizeof studio.triangle[0]);
    studio.skin.triangle_count = kept;
    studio.skin.paint = PAINT_FIELD;
    draw(pixels);
    assert_false(is_blue(pixels[HEIGHT / 2][WIDTH / 2]));
    studio.skin.two_sided = true;
    draw(pixels);
    assert_true(is_blue(pixels[HEIGHT / 2][WIDTH / 2]));
}

static void an_empty_picture_is_an_empty_studio(void** state) {
    (void)state;
    studio.picture.skin_count = 0;
    draw(pixels);
    assert_int_equal(red_pixels(), 0);
    studio.picture.floor = false;
    draw(others);
    assert_memory_equal(pixels[0][0], others[0][0], 3);
}

// The light that is left on the floor at (x, 0) as a part of 1.
static double light_at(const Shadow* shadow, double x) {
    const double reach = (double)shadow_reach(&studio.picture);
    const int column = (int)((x / reach + 1) * SHADOW_CELLS / 2 + 0.5);
    return shadow->light[SHADOW_CELLS / 2 * SHADOW_SIDE + column][1] / 255.0;
}

static void a_shadow_is_dark_below_and_gone_far_away(void** state) {
    (void)state;
    Shadow shadow = shadow_open();
    studio.picture.floor_height = 0.9f;
    shadow_cast(&shadow, &studio.picture);
    assert_less(light_at(&shadow, 0.2), 0.45);
    assert_less(0.97, light_at(&shadow, -4));
    shadow_close(&shadow);
}

static void a_higher_balloon_casts_a_fainter_shadow(void** state) {
    (void)state;
    Shadow shadow = shadow_open();
    double last = 0;
    for (int i = 0; i < 4; i++) {
        blow_up(1, 1.1f + (float)i);
        shadow_cast(&shadow, &studio.picture);
        double darkest = 1;
        for (int k = 0; k < SHADOW_SIDE * SHADOW_SIDE; k++)
            darkest = fmin(darkest, shadow.light[k][1] / 255.0);
        assert_less(last, darkest);
        last = darkest;
    }
    shadow_close(&shadow);
}

static void the_floor_under_a_balloon_is_darker(void** state) {
    (void)state;
    studio.picture.floor_height = 0.9f;
    draw(pixels);
    studio.picture.skin_count = 0;
    draw(others);
    // just below the balloon's outline, right of its middle, where the key throws its shadow
    assert_less(brightness(pixels[88][WIDTH / 2 + 8]), brightness(others[88][WIDTH / 2 + 8]) - 60);
}

static void depth_sort_is_far_to_near_and_stable(void** state) {
    (void)state;
    enum { COUNT = 1000 };
    static float depth[COUNT];
    static int order[COUNT];
    static uint64_t scratch[2 * COUNT];
    for (int i = 0; i < COUNT; i++)
        depth[i] = (float)(i * 7919 % 250);
    depth_sort(depth, COUNT, order, scratch);
    for (int i = 1; i < COUNT; i++) {
        const float before = depth[order[i - 1]], here = depth[order[i]];
        assert_true(before > here || (before == here && order[i - 1] < order[i]));
    }
}

static void the_overlay_says_the_same_twice_and_stays_in_its_corner(void** state) {
    (void)state;
    Fault fault = {0};
    assert_true(hud_open(1, &fault));
    Panel panel = {.shown = true, .title = "title"};
    panel_row(&panel, "label", "%d", 42);
    Pixels* both[2] = {&pixels, &others};
    for (int i = 0; i < 2; i++) {
        renderer_draw(renderer, &studio.picture);
        hud_draw(&panel, WIDTH, HEIGHT);
        renderer_read(renderer, (*both[i])[0][0]);
    }
    assert_memory_equal(pixels, others, sizeof pixels);

    draw(others);
    assert_memory_not_equal(pixels[20], others[20], sizeof pixels[20]);
    assert_memory_equal(pixels[HEIGHT - 1], others[HEIGHT - 1], sizeof pixels[0]);
    hud_close();
}

enum { WIDE = 1280, HIGH = 720 }; // where a page has room
static unsigned char large[2][HIGH][WIDE][3];

/// Its column is the right part of the picture, its slider the lower left; what rises is drawn
/// rising.
static void the_labs_page_draws_its_plots_on_the_right(void** state) {
    (void)state;
    Fault fault = {0};
    assert_true(hud_open(1, &fault));
    renderer_resize(renderer, WIDE, HIGH);
    static Page page = {.title = "Balloon 0", .count = 2, .t = {0, 1}, .plot_count = 1};
    page.map.method = "euler";
    page.plot[0] = (PagePlot){.label = "volume", .value = "2", .y = {1, 2}};
    const Panel panel = {.page = &page};
    const int left = 954, center = 1104, top = 69, middle = 90, low = 111; // of hud/page.cpp
    int bright[2][2] = {{0}}; // in the left half of the plot, above and below its middle
    for (int i = 0; i < 2; i++) {
        page.plot[0].y[1 - i] = 1;
        page.plot[0].y[i] = 2;
        renderer_draw(renderer, &studio.picture);
        hud_draw(&panel, WIDE, HIGH);
        renderer_read(renderer, large[i][0][0]);
        for (int y = top; y < low; y++)
            for (int x = left; x < center; x++)
                bright[i][y >= middle] += brightness(large[i][y][x]) > 400;
    }
    assert_true(bright[1][1] > bright[1][0]); // rising
    assert_true(bright[0][0] > bright[0][1]); // falling

    renderer_draw(renderer, &studio.picture);
    renderer_read(renderer, large[0][0][0]);
    for (int y = 0; y < 640; y++)
        assert_memory_equal(large[0][y], large[1][y], 3 * 940);
    hud_close();
}

/// What a click finds is what is drawn there.
static void a_cell_of_the_map_is_found_where_it_is_drawn(void** state) {
    (void)state;
    Fault fault = {0};
    assert_true(hud_open(1, &fault));
    renderer_resize(renderer, WIDE, HIGH);
    static Page page = {.map.method = "euler"};
    Panel panel = {.page = &page};
    const int lit[][2] = {{0, 0}, {4, 6}, {PAGE_ROWS - 1, PAGE_COLUMNS - 1}};
    for (int k = 0; k < 3; k++) {
        PageCell* cell = &page.map.cell[lit[k][0]][lit[k][1]];
        for (int on = 0; on < 2; on++) {
            *cell = on ? PAGE_EXPLODED : PAGE_UNKNOWN;
            renderer_draw(renderer, &studio.picture);
            hud_draw(&panel, WIDE, HIGH);
            renderer_read(renderer, large[on][0][0]);
        }
        *cell = PAGE_UNKNOWN;
        int found = 0, drawn = 0, both = 0;
        for (int y = 0; y < HIGH; y++)
            for (int x = 0; x < WIDE; x++) {
                const float at[2] = {((float)x + 0.5f) / WIDE, ((float)y + 0.5f) / HIGH};
                int got[2] = {-1, -1};
                const bool in = hud_cell(&panel, WIDE, HIGH, at, got) && got[0] == lit[k][0] &&
                                got[1] == lit[k][1];
                const bool red = memcmp(large[0][y][x], large[1][y][x], 3) != 0;
                found += in;
                drawn += red;
                both += in && red;
            }
        assert_true(drawn > 50 && both == drawn && drawn > found * 7 / 10);
    }
    panel.help_shown = true;
    assert_false(hud_cell(&panel, WIDE, HIGH, (const float[]){0.85f, 0.1f}, (int[2]){0}));
    hud_close();
}

static void a_panel_takes_no_more_rows_than_it_has(void** state) {
    (void)state;
    static Panel panel;
    for (int i = 0; i < 2 * PANEL_ROWS; i++)
        panel_row(&panel, "a label that is longer than the room for it is", "%0200d", i);
    assert_int_equal(panel.row_count, PANEL_ROWS);
    assert_int_equal(strlen(panel.row[0].value), PANEL_TEXT - 1);
}

static int open_all(void** state) {
    (void)state;
    Fault fault = {0};
    if (egl_open_surfaceless(&egl, &fault) &&
        renderer_open(&renderer, WIDTH, HEIGHT, "shaders", &fault))
        return 0;
    fault_print(&fault, stderr);
    return 1;
}

static int close_all(void** state) {
    (void)state;
    renderer_close(renderer);
    egl_close_surfaceless(&egl);
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_balloon_is_in_the_middle_of_a_pale_studio, set_up),
        cmocka_unit_test_setup(a_balloon_covers_what_its_radius_says, set_up),
        cmocka_unit_test_setup(a_stamp_changes_nothing_of_what_is_drawn, set_up),
        cmocka_unit_test_setup(the_same_picture_gives_the_same_bytes, set_up),
        cmocka_unit_test_setup(a_size_drawn_before_another_leaves_no_trace, set_up),
        cmocka_unit_test_setup(stretched_rubber_is_paler, set_up),
        cmocka_unit_test_setup(a_ball_behind_shows_only_through_stretched_rubber, set_up),
        cmocka_unit_test_setup(a_field_is_drawn_in_its_own_colours, set_up),
        cmocka_unit_test_setup(a_line_on_the_skin_is_seen_in_front_and_not_behind, set_up),
        cmocka_unit_test_setup(a_faint_shape_veils_a_line_within_and_hides_none, set_up),
        cmocka_unit_test_setup(what_is_selected_glows_around_and_nowhere_else, set_up),
        cmocka_unit_test_setup(an_open_skin_shows_its_inside, set_up),
        cmocka_unit_test_setup(an_empty_picture_is_an_empty_studio, set_up),
        cmocka_unit_test_setup(a_shadow_is_dark_below_and_gone_far_away, set_up),
        cmocka_unit_test_setup(a_higher_balloon_casts_a_fainter_shadow, set_up),
        cmocka_unit_test_setup(the_floor_under_a_balloon_is_darker, set_up),
        cmocka_unit_test(depth_sort_is_far_to_near_and_stable),
        cmocka_unit_test_setup(the_overlay_says_the_same_twice_and_stays_in_its_corner, set_up),
        cmocka_unit_test_setup(the_labs_page_draws_its_plots_on_the_right, set_up),
        cmocka_unit_test_setup(a_cell_of_the_map_is_found_where_it_is_drawn, set_up),
        cmocka_unit_test(a_panel_takes_no_more_rows_than_it_has),
    };
    return cmocka_run_group_tests(tests, open_all, close_all);
}
