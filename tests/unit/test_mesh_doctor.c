/// The doctor: mended and refused meshes, the reasons, and the lines of its report.
#include "meshes.h"

static void sound_cube_needs_nothing(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load_good(CUBE_POINTS CUBE_FACES, &mesh);
    assert_int_equal(report.points, 8);
    assert_int_equal(report.quads, 6);
    assert_int_equal(report.triangles, 0);
    assert_int_equal(report.valence[3], 8);
    assert_int_equal(report.components, 1);
    assert_int_equal(report.genus, 0);
    assert_int_equal(report.rims, 0);
    assert_int_equal(report.flipped_faces, 0);
    assert_int_equal(report.welded_points, 0);
    assert_true(report.area == 24);
    assert_close(report.volume, 8.0, 1e-15);
    assert_true(mesh.closed);
    mesh_free(&mesh);
}

/// Each side of the cube has its own points, the last ones with negative zeros.
static void seams_are_welded(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report =
        load_good("v 0 1 0\nv 1 1 0\nv 1 0 0\nv 0 0 0\nf 1 2 3 4\n"
                  "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 5 6 7 8\n"
                  "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 9 10 11 12\n"
                  "v 1 0 0\nv 1 1 0\nv 1 1 1\nv 1 0 1\nf -4 -3 -2 -1\n"
                  "v 1 1 0\nv 0 1 0\nv 0 1 1\nv 1 1 1\nf -4 -3 -2 -1\n"
                  "v -0 1 -0\nv -0 -0 -0\nv -0 -0 1\nv -0 1 1\nf -4 -3 -2 -1\n",
                  &mesh);
    assert_int_equal(report.welded_points, 16);
    assert_int_equal(report.unused_points, 0);
    assert_int_equal(mesh.point_count, 8);
    assert_int_equal(mesh.edge_count, 12);
    assert_true(mesh.closed);
    assert_close(report.volume, 1.0, 1e-15);
    mesh_free(&mesh);
}

/// Two coincident sheets that share points by index form a flat pillow, not one sheet.
static void sewn_flat_sheets_stay_two(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load_good("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"
                                        "v 0 2 0\nv 0 1 0\nv 1 1 0\nv 1 1 0\n"
                                        "f 1 2 9 8\nf 2 3 4 9\nf 8 9 6 7\nf 9 4 5 6\n"
                                        "f 8 10 2 1\nf 10 4 3 2\nf 7 6 10 8\nf 6 5 4 10\n",
                                        &mesh);
    assert_int_equal(report.welded_points, 0);
    assert_int_equal(report.flipped_faces, 0);
    assert_int_equal(mesh.point_count, 10);
    assert_true(mesh.closed);
    mesh_free(&mesh);
}

/// Three sheets have a rim edge at one position; sewn, it would have three faces.
static void touching_rims_stay_apart(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load_good("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
                                        "v 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 5 6 7 8\n"
                                        "v 1 0 0\nv 1 0 1\nv 1 1 1\nv 1 1 0\nf 9 10 11 12\n",
                                        &mesh);
    assert_int_equal(report.welded_points, 0);
    assert_int_equal(report.components, 3);
    assert_int_equal(report.rims, 3);
    mesh_free(&mesh);
}

/// Rims that touch in one point only are not sewn.
static void touching_tips_stay_apart(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load_good("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
                                        "v 0 0 0\nv -1 0 0\nv 0 -1 0\nf 4 5 6\n",
                                        &mesh);
    assert_int_equal(report.welded_points, 0);
    assert_int_equal(report.components, 2);
    mesh_free(&mesh);
}

static void flipped_faces_are_turned(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load_good(CUBE_POINTS "f 4 3 2 1\nf 5 8 7 6\nf 1 2 6 5\nf 2 3 7 6\n"
                                                    "f 3 7 8 4\nf 4 1 5 8\n",
                                        &mesh);
    assert_int_equal(report.flipped_faces, 2);
    assert_close(report.volume, 8.0, 1e-15);
    mesh_free(&mesh);
}

/// Inside out, except for one face of six: the other five are flipped.
static void closed_skins_face_outward(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load_good(CUBE_POINTS "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\n"
                                                    "f 7 8 4 3\nf 4 1 5 8\n",
                                        &mesh);
    assert_int_equal(report.flipped_faces, 5);
    assert_close(report.volume, 8.0, 1e-15);
    mesh_free(&mesh);
}

/// An open sheet has no outside: its majority keeps its orientation.
static void open_sheets_keep_their_majority(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load_good("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\n"
                                        "v 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
                                        "f 1 2 6 5\nf 2 6 7 3\nf 3 7 8 4\n",
                                        &mesh);
    assert_int_equal(report.flipped_faces, 1);
    assert_int_equal(report.rims, 1);
    assert_int_equal(report.rim_edges, 8);
    assert_true(mesh.face[0][1] == mesh.inside[1]); // it was flipped and kept its first corner
    mesh_free(&mesh);
}

static void unused_points_are_left_out(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report =
        load_good("v 9 9 9\nv 0 0 0\nv 8 8 8\nv 1 0 0\nv 0 1 0\nv 7 7 7\nf 4 5 2\n", &mesh);
    assert_int_equal(report.unused_points, 3);
    assert_int_equal(report.points, 3);
    assert_true(mesh.point[mesh.inside[0]][0] == 1);
    assert_true(mesh.point[mesh.inside[1]][1] == 1);
    mesh_free(&mesh);
}

/// Two tori in one file: the genus is the sum of both.
static void genus_counts_all_holes(void** state) {
    (void)state;
    enum { N = 5 };
    char text[4096] = "";
    size_t length = 0;
    for (int part = 0; part < 2; part++) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                const double a = 6.2831853 * i / N, b = 6.2831853 * j / N;
                const double r = 2 + cos(b);
                length += (size_t)snprintf(text + length, sizeof text - length, "v %g %g %g\n",
                                           9 * part + r * cos(a), r * sin(a), sin(b));
            }
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++) {
                const int base = 1 + N * N * part, k = (i + 1) % N * N, l = (j + 1) % N;
                length += (size_t)snprintf(text + length, sizeof text - length, "f %d %d %d %d\n",
                                           base + i * N + j, base + k + j, base + k + l,
                                           base + i * N + l);
            }
    }
    Mesh mesh;
    const MeshReport report = load_good(text, &mesh);
    assert_int_equal(report.components, 2);
    assert_int_equal(report.genus, 2);
    assert_int_equal(report.points - mesh.edge_count + mesh.face_count, 0);
    mesh_free(&mesh);
}

static void degenerate_faces_are_refused(void** state) {
    (void)state;
    refuse_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 3\n", "mesh.obj:4",
                "face 1 has two corners in one place");
    refuse_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 1 4\n", "mesh.obj:6",
                "face 2 has two corners in one place");
    refuse_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 0 0\nf 1 2 3 4\n", "mesh.obj:5",
                "face 1 has two corners in one place");
    refuse_text("v 0 0 0\nv 0.1 0.1 0.1\nv 0.3 0.3 0.3\nf 1 2 3\n", "mesh.obj:4",
                "face 1 has no area");
}

static void duplicate_faces_are_refused(void** state) {
    (void)state;
    refuse_text(CUBE_POINTS CUBE_FACES "f 2 1 4 3\n", "mesh.obj:15",
                "face 7 has the same corners as face 1");
    refuse_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 2 1\n", "mesh.obj:5",
                "face 2 has the same corners as face 1");
}

static void edges_of_three_faces_are_refused(void** state) {
    (void)state;
    refuse_text("v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n",
                "mesh.obj:6", "the edge from vertex 1 to vertex 2 belongs to 3 faces");
}

static void sheets_that_touch_in_a_point_are_refused(void** state) {
    (void)state;
    refuse_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nf 1 2 3\nf 1 4 5\n", "mesh.obj:1",
                "two sheets touch in vertex 1 alone");
}

static void one_sided_surfaces_are_refused(void** state) {
    (void)state;
    refuse_text("v 1 0 0\nv 2 0 1\nv -1 2 0\nv -2 3 1\nv -1 -2 1\nv -2 -3 0\n"
                "f 1 2 4 3\nf 3 4 6 5\nf 5 6 1 2\n",
                "mesh.obj:9", "only one side");
}

/// The report of an unusable mesh counts all flaws; the first one is the reason.
static void report_counts_all_flaws(void** state) {
    (void)state;
    Mesh mesh;
    MeshReport report;
    Fault fault = {0};
    assert_false(
        load_text(CUBE_POINTS CUBE_FACES "f 2 1 4 3\nf 1 1 2\nv 5 5 5\n", &mesh, &report, &fault));
    assert_int_equal(report.points, 8);
    assert_int_equal(report.quads, 7);
    assert_int_equal(report.triangles, 1);
    assert_int_equal(report.duplicate_faces, 1);
    assert_int_equal(report.degenerate_faces, 1);
    assert_int_equal(report.nonmanifold_edges, 4);
    assert_int_equal(report.unused_points, 1);
    assert_non_null(strstr(fault.text, "face 8"));
    assert_string_equal(fault.text, report.unusable.text);
    assert_int_equal(mesh.point_count, 0);
}

/// Random triangles and quads between points of a small lattice, many of which coincide.
static void make_soup(MeshSource* source, Random* random) {
    const int points = 4 + (int)(20 * random_next(random));
    const int faces = 1 + (int)(12 * random_next(random));
    source_make(source, "soup", points, faces);
    for (int i = 0; i < points; i++)
        for (int k = 0; k < 3; k++)
            source->point[i][k] = (int)(2.2 * random_next(random));
    for (int f = 0; f < faces; f++) {
        for (int k = 0; k < 4; k++)
            source->face[f][k] = (int)(points * random_next(random));
        if (random_next(random) < 0.5)
            source->face[f][3] = NONE;
    }
}

/// A mesh that the doctor accepts needs no further mending, and the doctor ends on any input.
static void treated_meshes_need_no_treatment(void** state) {
    (void)state;
    Random random = {11};
    int usable = 0;
    for (int round = 0; round < 20000; round++) {
        MeshSource source;
        make_soup(&source, &random);
        Mesh mesh;
        MeshReport first, second;
        const bool good = doctor_treat(&source, &mesh, &first);
        mesh_free(&mesh);
        if (good) {
            usable++;
            assert_true(doctor_treat(&source, &mesh, &second));
            assert_int_equal(second.welded_points, 0);
            assert_int_equal(second.flipped_faces, 0);
            assert_int_equal(second.unused_points, 0);
            assert_int_equal(second.genus, first.genus);
            assert_int_equal(second.rims, first.rims);
            assert_true(second.area == first.area);
            assert_true(second.volume >= 0);
            mesh_free(&mesh);
        }
        source_free(&source);
    }
    assert_in_range(usable, 500, 19500);
}

static void doctor_prints_one_line_per_finding(void** state) {
    (void)state;
    Mesh mesh;
    const MeshReport report = load("torus:7x5", &mesh);
    char* text = NULL;
    size_t size = 0;
    FILE* out = open_memstream(&text, &size);
    doctor_print(&report, out);
    fclose(out);
    const char* const lines[] = {"vertices: 35\n",
                                 "faces: 35 (35 quads, 0 triangles)\n",
                                 "valence: 4:35\n",
                                 "components: 1\n",
                                 "genus: 1\n",
                                 "boundary edges: 0\n",
                                 "non-manifold edges: 0\n",
                                 "duplicate faces: 0\n",
                                 "degenerate faces: 0\n",
                                 "flipped faces: 0\n",
                                 "seams: 0 vertices welded\n",
                                 "unused vertices: 0\n",
                                 "area: ",
                                 " (closed)\n"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        if (!strstr(text, lines[i]))
            fail_msg("no \"%s\" in\n%s", lines[i], text);
    free(text);
    mesh_free(&mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sound_cube_needs_nothing),
        cmocka_unit_test(seams_are_welded),
        cmocka_unit_test(sewn_flat_sheets_stay_two),
        cmocka_unit_test(touching_rims_stay_apart),
        cmocka_unit_test(touching_tips_stay_apart),
        cmocka_unit_test(flipped_faces_are_turned),
        cmocka_unit_test(closed_skins_face_outward),
        cmocka_unit_test(open_sheets_keep_their_majority),
        cmocka_unit_test(unused_points_are_left_out),
        cmocka_unit_test(genus_counts_all_holes),
        cmocka_unit_test(degenerate_faces_are_refused),
        cmocka_unit_test(duplicate_faces_are_refused),
        cmocka_unit_test(edges_of_three_faces_are_refused),
        cmocka_unit_test(sheets_that_touch_in_a_point_are_refused),
        cmocka_unit_test(one_sided_surfaces_are_refused),
        cmocka_unit_test(report_counts_all_flaws),
        cmocka_unit_test(treated_meshes_need_no_treatment),
        cmocka_unit_test(doctor_prints_one_line_per_finding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
