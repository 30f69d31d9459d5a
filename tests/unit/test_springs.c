/// Springs: the number of each kind, and that each pair of particles occurs once.
#include <sys/resource.h>

#include "bodies.h"

static void count(const char* name, int want[SPRING_KINDS]) {
    Mesh mesh;
    Springs springs = {0};
    mesh_of(name, &mesh);
    springs_find(&mesh, (bool[SPRING_KINDS]){true, true, true}, &springs);
    for (int kind = 0; kind < SPRING_KINDS; kind++) {
        const int got = springs.from[kind + 1] - springs.from[kind];
        if (got != want[kind])
            fail_msg("%s: %d %s springs, want %d", name, got, spring_kind_name[kind], want[kind]);
    }
    springs_free(&springs);
    mesh_free(&mesh);
}

static void cube_has_no_flexion(void** state) {
    (void)state;
    count("cube", (int[]){12, 12, 0});
}

static void cube_sphere_counts(void** state) {
    (void)state;
    for (int n = 2; n < 14; n++) {
        char name[32];
        snprintf(name, sizeof name, "cube-sphere:%d", n);
        count(name, (int[]){12 * n * n, 12 * n * n, 12 * n * n - 12});
    }
}

static void torus_counts(void** state) {
    (void)state;
    count("torus:5x5", (int[]){50, 50, 50});
    count("torus:24x12", (int[]){576, 576, 576});
}

static void pillow_counts(void** state) {
    (void)state;
    for (int n = 3; n < 9; n++) {
        char name[32];
        snprintf(name, sizeof name, "pillow:%d", n);
        count(name, (int[]){4 * n * n, 4 * n * n - 4, 4 * n * n - 8});
    }
}

static void open_grid_counts(void** state) {
    (void)state;
    const int size[][2] = {{1, 1}, {1, 4}, {3, 2}, {7, 9}};
    for (int k = 0; k < 4; k++) {
        const int a = size[k][0], b = size[k][1];
        char name[32];
        snprintf(name, sizeof name, "grid:%dx%d", a, b);
        count(name,
              (int[]){a * (b + 1) + b * (a + 1), 2 * a * b, (a - 1) * (b + 1) + (b - 1) * (a + 1)});
    }
}

/// On a triangle mesh flexion joins the far ends of two-edge paths too, and nothing has shear.
static void triangles_have_no_shear(void** state) {
    (void)state;
    Mesh mesh;
    Springs springs = {0};
    mesh_of("icosphere:2", &mesh);
    springs_find(&mesh, (bool[SPRING_KINDS]){true, true, true}, &springs);
    assert_int_equal(springs.from[SHEAR + 1] - springs.from[SHEAR], 0);
    assert_int_equal(springs.from[STRUCTURAL + 1], mesh.edge_count);

    // a valence d is the middle of d(d-3)/2 paths whose ends share no face; each path p-m-q with
    // both diagonals of one strip coincides with another, so count by brute force
    int want = 0;
    for (int p = 0; p < mesh.point_count; p++)
        for (int q = p + 1; q < mesh.point_count; q++) {
            bool shares = false, path = false;
            for (int f = 0; f < mesh.face_count; f++) {
                int hits = 0;
                for (int c = 0; c < face_corners(mesh.face[f]); c++)
                    hits += mesh.face[f][c] == p || mesh.face[f][c] == q;
                shares |= hits == 2;
            }
            for (int k = mesh.point_edge_from[p]; k < mesh.point_edge_from[p + 1]; k++) {
                const int m = mesh_across(&mesh, mesh.point_edge[k], p);
                for (int j = mesh.point_edge_from[m]; j < mesh.point_edge_from[m + 1]; j++)
                    path |= mesh_across(&mesh, mesh.point_edge[j], m) == q;
            }
            want += path && !shares;
        }
    assert_int_equal(springs.from[FLEXION + 1] - springs.from[FLEXION], want);
    springs_free(&springs);
    mesh_free(&mesh);
}

static int compare_pairs(const void* a, const void* b) {
    return memcmp(a, b, 2 * sizeof(int));
}

static void each_pair_is_there_once(void** state) {
    (void)state;
    const char* names[] = {"pillow:3", "torus:3x3", "disc:4x7", "discs:3x6", "cube-sphere:5"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        Mesh mesh;
        Springs springs = {0};
        mesh_of(names[n], &mesh);
        springs_find(&mesh, (bool[SPRING_KINDS]){true, true, true}, &springs);
        for (int s = 0; s < springs.count; s++) {
            int* end = springs.end[s];
            assert_int_not_equal(end[0], end[1]);
            if (end[0] > end[1]) {
                const int low = end[1];
                end[1] = end[0];
                end[0] = low;
            }
        }
        qsort(springs.end, (size_t)springs.count, sizeof *springs.end, compare_pairs);
        for (int s = 1; s < springs.count; s++)
            assert_int_not_equal(compare_pairs(springs.end[s - 1], springs.end[s]), 0);
        springs_free(&springs);
        mesh_free(&mesh);
    }
}

/// Springs of a kind without stiffness are neither stored nor computed.
static void unwanted_kinds_do_not_exist(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    mesh_of("cube-sphere:4", &mesh);
    body_of(&mesh, &body);
    body_add_springs(&body, (double[SPRING_KINDS]){50, 0, 0}, LAW_HOOKE);
    assert_int_equal(body.springs.count, 12 * 4 * 4);
    body_free(&body);
    mesh_free(&mesh);
}

/// On a mesh of valence 4 each point is the middle of two straight paths; a cube's corners of none.
static void torsion_paths_are_those_of_flexion(void** state) {
    (void)state;
    Mesh mesh;
    Torsion torsion = {0};
    mesh_of("torus:8x6", &mesh);
    torsion_find(&mesh, &torsion);
    assert_int_equal(torsion.count, 2 * mesh.point_count);
    torsion_free(&torsion);
    mesh_free(&mesh);

    mesh_of("cube-sphere:4", &mesh);
    torsion_find(&mesh, &torsion);
    assert_int_equal(torsion.count, 2 * (mesh.point_count - 8));
    torsion_free(&torsion);
    mesh_free(&mesh);
}

/// Two fans of triangles, each around a pole of `count` edges.
static void poles(int count, Mesh* mesh) {
    double4* point = new_array(double4, count + 2);
    int(*face)[4] = new_array(int[4], 2 * count);
    point[count] = (double4){0, 1, 0};
    point[count + 1] = (double4){0, -1, 0};
    for (int i = 0; i < count; i++) {
        const double angle = 2 * 3.141592653589793 * i / count;
        point[i] = (double4){cos(angle), 0, sin(angle)};
        const int next = (i + 1) % count;
        memcpy(face[2 * i], (int[4]){count, next, i, NONE}, sizeof *face);
        memcpy(face[2 * i + 1], (int[4]){count + 1, i, next, NONE}, sizeof *face);
    }
    mesh_make(mesh, point, count + 2, (const int(*)[4])face, 2 * count);
    free(point);
    free(face);
}

/// Time is linear in the edges: quadratic time for 200,000 around one vertex would exceed the
/// limit.
static void a_vertex_may_have_any_number_of_edges(void** state) {
    (void)state;
    enum { COUNT = 200000 };
    struct rlimit before, limit;
    getrlimit(RLIMIT_CPU, &before);
    limit = (struct rlimit){.rlim_cur = 60, .rlim_max = before.rlim_max};
    setrlimit(RLIMIT_CPU, &limit);
    Mesh mesh;
    Body body;
    poles(COUNT, &mesh);
    body_of(&mesh, &body);
    body_add_springs(&body, (double[SPRING_KINDS]){50, 0, 0}, LAW_HOOKE);
    assert_int_equal(body.springs.count, 3 * COUNT);
    int vertex;
    assert_true(springs_paths(&mesh, &vertex) > (double)COUNT * COUNT);
    assert_true(mesh.loaded[vertex] >= COUNT); // a pole
    body_free(&body);
    mesh_free(&mesh);
    setrlimit(RLIMIT_CPU, &before);
}

/// The paths are the pairs of edges at a vertex: of them are flexion springs, shear springs, and
/// the third sides of triangles.
static void paths_bound_the_flexion_springs(void** state) {
    (void)state;
    static const char* const names[] = {"torus:8x6", "cube-sphere:4", "icosphere:2", "grid:5x3"};
    for (int k = 0; k < 4; k++) {
        Mesh mesh;
        Springs springs = {0};
        int vertex;
        mesh_of(names[k], &mesh);
        springs_find(&mesh, (bool[SPRING_KINDS]){false, false, true}, &springs);
        assert_true(springs_paths(&mesh, &vertex) >= springs.count);
        springs_free(&springs);
        mesh_free(&mesh);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cube_has_no_flexion),
        cmocka_unit_test(cube_sphere_counts),
        cmocka_unit_test(torus_counts),
        cmocka_unit_test(pillow_counts),
        cmocka_unit_test(open_grid_counts),
        cmocka_unit_test(triangles_have_no_shear),
        cmocka_unit_test(each_pair_is_there_once),
        cmocka_unit_test(unwanted_kinds_do_not_exist),
        cmocka_unit_test(a_vertex_may_have_any_number_of_edges),
        cmocka_unit_test(paths_bound_the_flexion_springs),
        cmocka_unit_test(torsion_paths_are_those_of_flexion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
