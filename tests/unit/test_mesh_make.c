/// The mesh: its numbering, its edges and adjacency, and its triangles, for every shape.
#include "meshes.h"

#include "mesh/facet.h"
#include "mesh/reorder.h"
#include "mesh/shape.h"

/// Check a law for every row of the table of shapes.
static void for_every_shape(void (*law)(const char* name, const Mesh* mesh)) {
    for (int i = 0; i < shape_count; i++) {
        Mesh mesh;
        load(shape_table[i].name, &mesh);
        law(shape_table[i].name, &mesh);
        mesh_free(&mesh);
    }
}

static void check_permutation(const char* name, const Mesh* mesh) {
    (void)name;
    for (int i = 0; i < mesh->point_count; i++) {
        assert_in_range(mesh->loaded[i], 0, mesh->point_count - 1);
        assert_int_equal(mesh->inside[mesh->loaded[i]], i);
        assert_int_equal(mesh->loaded[mesh->inside[i]], i);
    }
}

static void order_is_a_permutation(void** state) {
    (void)state;
    for_every_shape(check_permutation);
}

/// Loaded numbers ascend in the order of first use by a face.
static void check_first_use(const char* name, const Mesh* mesh) {
    int next = 0;
    for (int f = 0; f < mesh->face_count; f++) {
        for (int k = 0; k < face_corners(mesh->face[f]); k++) {
            const int number = mesh->loaded[mesh->face[f][k]];
            if (number > next)
                fail_msg("%s: face %d uses point %d before %d", name, f, number, next);
            next += number == next;
        }
    }
    assert_int_equal(next, mesh->point_count);
}

static void loaded_order_is_that_of_first_use(void** state) {
    (void)state;
    for_every_shape(check_first_use);
}

static bool face_has_side(const int face[4], int a, int b) {
    const int corners = face_corners(face);
    for (int k = 0; k < corners; k++)
        if (face[k] == a && face[(k + 1) % corners] == b)
            return true;
    return false;
}

/// An edge runs forward in its first face and back in its second: neighbors are wound alike.
static void check_edges(const char* name, const Mesh* mesh) {
    (void)name;
    int sides = 0;
    int rim_edges = 0;
    for (int e = 0; e < mesh->edge_count; e++) {
        const int* end = mesh->edge[e];
        const int* face = mesh->edge_face[e];
        assert_true(face_has_side(mesh->face[face[0]], end[0], end[1]));
        assert_true(face[1] == NONE || face_has_side(mesh->face[face[1]], end[1], end[0]));
        sides += 1 + (face[1] != NONE);
        rim_edges += face[1] == NONE;
    }
    for (int f = 0; f < mesh->face_count; f++)
        sides -= face_corners(mesh->face[f]);
    assert_int_equal(sides, 0);
    assert_int_equal(mesh->closed, rim_edges == 0);
}

static void edges_have_one_or_two_faces_wound_alike(void** state) {
    (void)state;
    for_every_shape(check_edges);
}

static void check_adjacency(const char* name, const Mesh* mesh) {
    (void)name;
    int corners = 0;
    for (int i = 0; i < mesh->point_count; i++) {
        for (int k = mesh->point_face_from[i]; k < mesh->point_face_from[i + 1]; k++, corners++) {
            const int* c = mesh->face[mesh->point_face[k]];
            assert_true(c[0] == i || c[1] == i || c[2] == i || c[3] == i);
        }
        for (int k = mesh->point_edge_from[i]; k < mesh->point_edge_from[i + 1]; k++) {
            const int other = mesh_across(mesh, mesh->point_edge[k], i);
            assert_in_range(other, 0, mesh->point_count - 1);
            assert_int_equal(mesh_across(mesh, mesh->point_edge[k], other), i);
        }
    }
    for (int f = 0; f < mesh->face_count; f++)
        corners -= face_corners(mesh->face[f]);
    assert_int_equal(corners, 0);
    assert_int_equal(mesh->point_edge_from[mesh->point_count], 2 * mesh->edge_count);
}

static void points_know_their_faces_and_edges(void** state) {
    (void)state;
    for_every_shape(check_adjacency);
}

/// Two triangles a quad, in face order, with the quad's area vector.
static void check_triangles(const char* name, const Mesh* mesh) {
    int t = 0;
    for (int f = 0; f < mesh->face_count; f++) {
        const Facet facet = facet_of(mesh->point, mesh->face[f]);
        double4 rest = facet_area(&facet);
        for (int half = 0; half < facet.corners - 2; half++, t++) {
            const int* c = mesh->triangle[t];
            const int corner[4] = {c[0], c[1], c[2], NONE};
            const Facet part = facet_of(mesh->point, corner);
            rest -= facet_area(&part);
        }
        if (dlength(rest) > 1e-15)
            fail_msg("%s: face %d is not its triangles, off by %g", name, f, dlength(rest));
    }
    assert_int_equal(t, mesh->triangle_count);
}

static void triangles_cover_the_faces(void** state) {
    (void)state;
    for_every_shape(check_triangles);
}

static void quads_are_split_along_their_shorter_diagonal(void** state) {
    (void)state;
    // 0-2 shorter, 1-3 shorter, and equal, which splits along 0-2
    const char* text[] = {"v 0 0 0\nv 2 -1 0\nv 1 1 0\nv -1 2 0\nf 1 2 3 4\n",
                          "v 0 0 0\nv 1 0 0\nv 3 3 0\nv 0 1 0\nf 1 2 3 4\n",
                          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"};
    const int shared[3][2] = {{0, 2}, {1, 3}, {0, 2}};
    for (int i = 0; i < 3; i++) {
        Mesh mesh;
        load_good(text[i], &mesh);
        assert_int_equal(mesh.triangle_count, 2);
        for (int t = 0; t < 2; t++) {
            int found = 0;
            for (int k = 0; k < 3; k++)
                for (int s = 0; s < 2; s++)
                    found += mesh.loaded[mesh.triangle[t][k]] == shared[i][s];
            assert_int_equal(found, 2);
        }
        mesh_free(&mesh);
    }
}

/// For any numbering in the file, the numbers of neighbors differ by at most a front of the flood:
/// a multiple of the square root of the number of points.
static void neighbors_lie_close_in_memory(void** state) {
    (void)state;
    Mesh mesh;
    load("cube-sphere:40", &mesh);
    for (int e = 0; e < mesh.edge_count; e++)
        assert_less(abs(mesh.edge[e][0] - mesh.edge[e][1]), 2 * sqrt(mesh.point_count));
    mesh_free(&mesh);
}

/// Two chains and a single point: every component is numbered from one of its ends.
static void order_takes_every_component(void** state) {
    (void)state;
    //      0 - 2 - 4    1 - 5    3
    const int from[] = {0, 1, 2, 4, 4, 5, 6};
    const int neighbor[] = {2, 5, 0, 4, 2, 1};
    const int want[] = {3, 0, 2, 4, 1, 5};
    int loaded[6];
    reorder_points(6, from, neighbor, loaded);
    for (int i = 0; i < 6; i++)
        assert_int_equal(loaded[i], want[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_is_a_permutation),
        cmocka_unit_test(loaded_order_is_that_of_first_use),
        cmocka_unit_test(edges_have_one_or_two_faces_wound_alike),
        cmocka_unit_test(points_know_their_faces_and_edges),
        cmocka_unit_test(triangles_cover_the_faces),
        cmocka_unit_test(quads_are_split_along_their_shorter_diagonal),
        cmocka_unit_test(neighbors_lie_close_in_memory),
        cmocka_unit_test(order_takes_every_component),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
