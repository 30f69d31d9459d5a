/// Shapes: their counts and sizes, and that they need no mending.
#include "meshes.h"

#include "mesh/shapes/circle.h"
#include "mesh/shape.h"

typedef struct Counts {
    const char* name;
    int points;
    int faces;
    int edges;
    int genus;
    int rims;
} Counts;

// clang-format off
static const Counts counts[] = {
    {"cube",           8,                6,           12,          0, 0},
    {"cube:5",         152,              150,         300,         0, 0},
    {"box",            8,                6,           12,          0, 0},
    {"cube-sphere",    6 * 144 + 2,      6 * 144,     12 * 144,    0, 0},
    {"cube-sphere:1",  8,                6,           12,          0, 0},
    {"cube-sphere:43", 11096,            11094,       22188,       0, 0},
    {"icosphere:0",    12,               20,          30,          0, 0},
    {"icosphere:2",    162,              320,         480,         0, 0},
    {"icosphere",      642,              1280,        1920,        0, 0},
    {"torus",          288,              288,         576,         1, 0},
    {"torus:3x3",      9,                9,           18,          1, 0},
    {"torus:7x5",      35,               35,          70,          1, 0},
    {"capsule",        9 * 16 + 2,       10 * 16,     19 * 16,     0, 0},
    {"capsule:3x1",    2 * 3 + 2,        9,           15,          0, 0},
    {"grid",           121,              100,         220,         0, 1},
    {"grid:3x2",       12,               6,           17,          0, 1},
    {"grid:1x1",       4,                1,           4,           0, 1},
    {"pillow",         2 * 289 - 64,     512,         1024,        0, 0},
    {"pillow:2",       10,               8,           16,          0, 0},
    {"disc",           433,              432,         864,         0, 1},
    {"disc:1x3",       4,                3,           6,           0, 1},
    {"discs",          830,              864,         1692,        0, 0},
    {"discs:1x3",      5,                6,           9,           0, 0},
};
// clang-format on

static void shapes_have_their_counts(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        const Counts* want = &counts[i];
        Mesh mesh;
        const MeshReport report = load(want->name, &mesh);
        if (mesh.point_count != want->points || mesh.face_count != want->faces ||
            mesh.edge_count != want->edges || report.genus != want->genus ||
            report.rims != want->rims || mesh.closed != (want->rims == 0))
            fail_msg("%s: got %d points, %d faces, %d edges, genus %d, %d rims; "
                     "want %d, %d, %d, %d, %d",
                     want->name, mesh.point_count, mesh.face_count, mesh.edge_count, report.genus,
                     report.rims, want->points, want->faces, want->edges, want->genus, want->rims);
        mesh_free(&mesh);
    }
}

static void shapes_need_no_mending(void** state) {
    (void)state;
    for (int i = 0; i < shape_count; i++) {
        const Shape* shape = &shape_table[i];
        for (int minimal = 0; minimal < 2; minimal++) {
            const int* number = minimal ? shape->min : shape->usual;
            char name[64];
            if (shape->numbers == 1)
                snprintf(name, sizeof name, "%s:%d", shape->name, number[0]);
            else
                snprintf(name, sizeof name, "%s:%dx%d", shape->name, number[0], number[1]);
            Mesh mesh;
            const MeshReport report = load(name, &mesh);
            if (report.flipped_faces || report.welded_points || report.unused_points ||
                report.components != 1)
                fail_msg("%s: %d flipped, %d welded, %d unused, %d components", name,
                         report.flipped_faces, report.welded_points, report.unused_points,
                         report.components);
            assert_true(!mesh.closed || report.volume > 0);
            mesh_free(&mesh);
        }
    }
}

/// A name without numbers stands for the default numbers of the table.
static void shapes_have_defaults(void** state) {
    (void)state;
    Mesh plain, numbered;
    load("torus", &plain);
    load("torus:24x12", &numbered);
    assert_int_equal(plain.point_count, numbered.point_count);
    assert_memory_equal(plain.point, numbered.point, (size_t)plain.point_count * sizeof(double4));
    mesh_free(&plain);
    mesh_free(&numbered);
}

static void exact_cube_has_corners_at_one(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load("cube", &mesh);
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < 3; k++)
            assert_true(fabs(mesh.point[i][k]) == 1);
    assert_true(report.area == 24);
    assert_true(report.volume == 8);
    mesh_free(&mesh);
}

/// Halving the cells divides the error of a smooth surface's area and volume by four.
static void check_order_two(const char* coarse, const char* fine, double area, double volume) {
    Mesh mesh;
    const MeshReport a = load(coarse, &mesh);
    mesh_free(&mesh);
    const MeshReport b = load(fine, &mesh);
    mesh_free(&mesh);
    assert_near((area - a.area) / (area - b.area), 4, 0.2);
    assert_near((volume - a.volume) / (volume - b.volume), 4, 0.2);
}

static void round_shapes_converge_at_order_two(void** state) {
    (void)state;
    check_order_two("cube-sphere:12", "cube-sphere:24", 4 * PI, 4 * PI / 3);
    check_order_two("icosphere:3", "icosphere:4", 4 * PI, 4 * PI / 3);
    // the capsule's length is 4, its radius 1
    check_order_two("capsule:40x4", "capsule:80x8", 8 * PI, 2 * PI + 4 * PI / 3);
    check_order_two("torus:40x30", "torus:80x60", 4 * PI * PI * 0.4, 2 * PI * PI * 0.16);
}

/// Rest lengths are those of flat sheets to 1e-4, so a sewn sheet's truths are the flat one's.
static void sewn_sheets_are_nearly_flat(void** state) {
    (void)state;
    Mesh mesh;
    assert_close(load("pillow:40", &mesh).area, 8.0, 2e-4);
    mesh_free(&mesh);
    assert_close(load("discs:20x400", &mesh).area, 2 * acos(-1), 2e-4);
    mesh_free(&mesh);
}

static void circle_is_that_of_the_c_library(void** state) {
    (void)state;
    const int sizes[] = {3, 7, 12, 36, 1000};
    for (int i = 0; i < 5; i++) {
        const int n = sizes[i];
        for (int k = 0; k < n; k++) {
            const CirclePoint p = circle_point(k, n);
            const double angle = 2 * acos(-1) * k / n;
            // the angle itself is rounded, by up to 2 pi times 1e-16
            assert_near(p.cosine, cos(angle), 1.5e-15);
            assert_near(p.sine, sin(angle), 1.5e-15);
        }
    }
}

static void wrong_numbers_are_refused(void** state) {
    (void)state;
    const char* wrong[] = {"cube:0",    "cube:401",    "cube:",       "cube:2x2",
                           "cube:-3",   "cube: 3",     "torus:5",     "torus:2x5",
                           "torus:5x2", "torus:5x5x5", "icosphere:8", "grid:axb",
                           "grid:4x",   "grid:x4",     "disc:3,5",    "pillow:1",
                           "pillow:9e", "cube:1e2",    "grid:0x4",    "cube:99999999999"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        Mesh mesh;
        MeshReport report;
        Fault fault = {0};
        if (mesh_load(wrong[i], &mesh, &report, &fault))
            fail_msg("%s was made", wrong[i]);
        assert_string_equal(fault.location, wrong[i]);
        assert_non_null(strstr(fault.text, " from "));
    }
}

static void unknown_shapes_are_answered_with_the_list(void** state) {
    (void)state;
    Mesh mesh;
    MeshReport report;
    Fault fault = {0};
    assert_false(mesh_load("cubesphere:12", &mesh, &report, &fault));
    for (int i = 0; i < shape_count; i++)
        assert_non_null(strstr(fault.text, shape_table[i].name));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes_have_their_counts),
        cmocka_unit_test(shapes_need_no_mending),
        cmocka_unit_test(shapes_have_defaults),
        cmocka_unit_test(exact_cube_has_corners_at_one),
        cmocka_unit_test(round_shapes_converge_at_order_two),
        cmocka_unit_test(sewn_sheets_are_nearly_flat),
        cmocka_unit_test(circle_is_that_of_the_c_library),
        cmocka_unit_test(wrong_numbers_are_refused),
        cmocka_unit_test(unknown_shapes_are_answered_with_the_list),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
