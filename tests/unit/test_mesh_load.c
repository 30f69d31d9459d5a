/// Loading: exact topology at any size and position, every syntax of OBJ files, and a sentence with
/// its location for each file that cannot be read.
#include "meshes.h"

#include <locale.h>
#include <sys/stat.h>

/// A cube-sphere as text, scaled and moved.
static char* sphere_text(double scale, double offset, Mesh* mesh) {
    load("cube-sphere:6", mesh);
    char* text = NULL;
    size_t size = 0;
    FILE* out = open_memstream(&text, &size);
    for (int k = 0; k < mesh->point_count; k++) {
        const double4 p = mesh->point[mesh->inside[k]] * scale + offset;
        fprintf(out, "v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    }
    for (int f = 0; f < mesh->face_count; f++) {
        fprintf(out, "f");
        for (int k = 0; k < 4; k++)
            fprintf(out, " %d", mesh->loaded[mesh->face[f][k]] + 1);
        fprintf(out, "\n");
    }
    fclose(out);
    return text;
}

static void check_same_topology(const Mesh* got, const Mesh* want) {
    assert_int_equal(got->point_count, want->point_count);
    assert_int_equal(got->face_count, want->face_count);
    assert_memory_equal(got->face, want->face, (size_t)want->face_count * sizeof *want->face);
    assert_memory_equal(got->loaded, want->loaded,
                        (size_t)want->point_count * sizeof *want->loaded);
}

/// In assimp's floats, points 1e-6 apart would coincide at 1e7.
static void topology_is_exact_at_any_size_and_position(void** state) {
    (void)state;
    const double cases[][2] = {{1, 0},     {1e-12, 0}, {1e12, 0},    {1e-6, 1e7},
                               {1e-30, 0}, {1e30, 0},  {1e-6, -1e7}, {1, 1e12}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Mesh want, got;
        char* text = sphere_text(cases[i][0], cases[i][1], &want);
        const MeshReport report = load_good(text, &got);
        check_same_topology(&got, &want);
        assert_int_equal(report.flipped_faces, 0);
        for (int k = 0; k < want.point_count; k++) {
            const double4 p = want.point[k] * cases[i][0] + cases[i][1];
            for (int lane = 0; lane < 3; lane++)
                assert_true(got.point[k][lane] == p[lane]);
        }
        free(text);
        mesh_free(&want);
        mesh_free(&got);
    }
}

/// All of these are the same cube.
static void every_way_of_writing_is_understood(void** state) {
    (void)state;
    const char* const texts[] = {
        CUBE_POINTS "f 4 3 2 1\r\nf 5 6 7 8\r\nf 1 2 6 5\r\nf 2 3 7 6\r\nf 3 4 8 7\r\nf 4 1 5 8",
        "v -1 -1 -1\rv 1 -1 -1\rv 1 1 -1\rv -1 1 -1\rv -1 -1 1\rv 1 -1 1\rv 1 1 1\rv -1 1 1\r"
        "f 4 3 2 1\rf 5 6 7 8\rf 1 2 6 5\rf 2 3 7 6\rf 3 4 8 7\rf 4 1 5 8\r",
        "\xEF\xBB\xBF" CUBE_POINTS CUBE_FACES,
        "# a cube from C:\\meshes\\\n\n" CUBE_POINTS "\n  \t\n" CUBE_FACES "\n\n# end\n",
        CUBE_FACES CUBE_POINTS,
        CUBE_POINTS "f -5 -6 -7 -8\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf 2 3 -2 -3\nf 3 4 8 7\n"
                    "f 4 1 5 -1\n",
        CUBE_POINTS "f\t4   3 2\t1 \n\tf 5 6 7 8\n f 1 2 6 5\nf 2 \\\n 3 7 6\nf 3 4 \\\r\n8 7\n"
                    "f 4 1 \\  \n 5 8 # the \\\n",
        "v -1 -1 -1 1\nv 1 -1 -1 1.0\nv 1 1 -1 1\nv -1 1 -1 1\nv -1 -1 1 0.5 0.5 0.5\n"
        "v 1 -1 1 1 0 0\nv 1 1 1 0 1 0\nv +1e0 1 1\nv -10e-1 .1e1 1.\n"
        "f 4 3 2 1\nf 5 6 7 9\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 9 7\nf 4 1 5 9\n",
        CUBE_POINTS "f +4 03 002 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
        "mtllib none.mtl\no front\n" CUBE_POINTS "vt 0 0\nvt 1 0\nvn 0 0 1\ng one\nusemtl red\n"
        "f 4/1/1 3/2/1 2/1/1 1/2/1\nusemtl blue\nf 5//1 6//1 7//1 8//1\no back\nf 1/1 2/2 6/1 5/2\n"
        "usemtl red\ns 1\nf 2 3 7 6\ng one\nf 3/99/99 4/99/99 8/-7/-7 7/1/1\ng two three\n"
        "f 4 1 5 8\nunknown 1 2 3\n",
    };
    Mesh want;
    load_good(CUBE_POINTS CUBE_FACES, &want);
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        Mesh got;
        load_good(texts[i], &got);
        check_same_topology(&got, &want);
        assert_memory_equal(got.point, want.point, 8 * sizeof *want.point);
        mesh_free(&got);
    }
    mesh_free(&want);
}

/// The user's locale, with a decimal comma, does not affect the file's numbers.
static void locale_does_not_matter(void** state) {
    (void)state;
    static const char* const names[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"};
    bool found = false;
    for (int i = 0; i < 3; i++)
        found = found || setlocale(LC_NUMERIC, names[i]);
    if (!found)
        skip();
    Mesh mesh;
    const MeshReport report = load_good("v 0 0 0\nv 1.5 0 0\nv 0 1.5 0\nf 1 2 3\n", &mesh);
    setlocale(LC_NUMERIC, "C");
    assert_true(report.area == 1.125);
    mesh_free(&mesh);
}

static void bad_lines_are_named(void** state) {
    (void)state;
    // clang-format off
    static const char* const cases[][3] = {
        {"v 0 0 0\nv nan 0 0\nf 1 2 1\n",        "mesh.obj:2", "'nan' is not a finite number"},
        {"v 0 0 0\nv 0 -inf 0\nf 1 2 1\n",       "mesh.obj:2", "'-inf' is not a finite number"},
        {"v 0 0 1e999\n",                        "mesh.obj:1", "'1e999' is not a finite number"},
        {"v 0 0\n",                              "mesh.obj:1", "three coordinates, here are 2"},
        {"v\n",                                  "mesh.obj:1", "three coordinates, here are 0"},
        {"v 1 2 \\\n",                           "mesh.obj:1", "three coordinates, here are 2"},
        {"v 0,5 0 0\n",                          "mesh.obj:1", "'0,5' is not a number"},
        {"#\n\nv 0 0 x\n",                       "mesh.obj:3", "'x' is not a number"},
        {"v 0 0 0 red\n",                        "mesh.obj:1", "'red' is not a number"},
        {"v 0 0 0\nf 1\n",                       "mesh.obj:2", "face 1 has 1 corner;"},
        {"v 0 0 0\nv 1 0 0\nf 1 2\n",            "mesh.obj:3", "face 1 has 2 corners;"},
        {"v 0 0 0\nf\n",                         "mesh.obj:2", "face 1 has 0 corners;"},
        {CUBE_POINTS "f 1 2 3 4\nf 1 2 3 4 5\n", "mesh.obj:10", "face 2 has 5 corners; only quads"},
        {CUBE_POINTS "f 1 2 3 \\\n4 5 6\n",      "mesh.obj:9", "face 1 has 6 corners;"},
        {CUBE_POINTS "l 1 2\n",                  "mesh.obj:9", "'l' draws loose lines"},
        {CUBE_POINTS "p 1\n",                    "mesh.obj:9", "'p' draws loose points"},
        {CUBE_POINTS "f 1 2 9\n",                "mesh.obj:9", "vertex 9, but there are only 8"},
        {CUBE_POINTS "f 1 2 3\n\nf 1 -9 3\n",    "mesh.obj:11", "face 2 names vertex -9, but"},
        {"v 0 0 0\nf -1 -2 1\nv 1 0 0\n",        "mesh.obj:2", "vertex -2, but there are only 1 above"},
        {CUBE_POINTS "f 1 2 0\n",                "mesh.obj:9", "vertex 0; they count from 1"},
        {CUBE_POINTS "f 1 2 4294967299\n",       "mesh.obj:9", "there is no vertex 4294967299"},
        {CUBE_POINTS "f 1 2 2147483648\n",       "mesh.obj:9", "there is no vertex 2147483648"},
        {CUBE_POINTS "f 1 2 3x\n",               "mesh.obj:9", "'3x' is not a corner"},
        {CUBE_POINTS "f 1 2 /3\n",               "mesh.obj:9", "'/3' is not a corner"},
        {CUBE_POINTS "f 1 2 3.5\n",              "mesh.obj:9", "'3.5' is not a corner"},
        {CUBE_POINTS "f 1 2 1-2\n",              "mesh.obj:9", "'1-2' is not a corner"},
        {CUBE_POINTS "f 1 2 -\n",                "mesh.obj:9", "'-' is not a corner"},
        {CUBE_POINTS "f 1, 2, 3\n",              "mesh.obj:9", "'1,' is not a corner"},
        {"",                                     "mesh.obj",   "is empty"},
        {"f 1 2 3\n",                            "mesh.obj",   "has no vertices"},
        {"Dear reader,\n",                       "mesh.obj",   "has no vertices"},
        {CUBE_POINTS,                            "mesh.obj",   "has no faces"},
    };
    // clang-format on
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        refuse_text(cases[i][0], cases[i][1], cases[i][2]);
}

static void refuse_path(const char* path, const char* words) {
    Mesh mesh;
    MeshReport report;
    Fault fault = {0};
    assert_false(mesh_load(path, &mesh, &report, &fault));
    assert_string_equal(fault.location, path);
    if (!strstr(fault.text, words))
        fail_msg("%s: got \"%s\", want \"%s\"", path, fault.text, words);
}

static void bad_files_are_named(void** state) {
    (void)state;
    refuse_path("no/such/mesh.obj", "No such file");
    refuse_path("", "no such file");

    const TextFile binary = write_bytes("mesh.obj", "v 0 0 0\n\0\1\2", 11);
    refuse_path(binary.path, "is a binary file");
    remove_file(&binary);

    const TextFile large = write_bytes("mesh.obj", "v", 1);
    assert_int_equal(truncate(large.path, 300 << 20), 0); // a sparse file
    refuse_path(large.path, "has 314572800 bytes; at most 268435456 can be read");
    remove_file(&large);

    const TextFile other = write_bytes("mesh.ply", "ply\n", 4);
    refuse_path(other.path, "is not a mesh file (.obj, .stl, .off, .glb, .gltf); convert it with");
    remove_file(&other);

    const TextFile secret = write_bytes("mesh.obj", "v 0 0 0\n", 8);
    chmod(secret.path, 0);
    if (access(secret.path, R_OK) != 0) // root reads everything
        refuse_path(secret.path, "Permission denied");
    remove_file(&secret);

    TextFile folder = write_bytes("mesh.obj", "", 0);
    unlink(folder.path);
    assert_int_equal(mkdir(folder.path, 0700), 0);
    refuse_path(folder.path, "is a folder");
    rmdir(folder.path);
    rmdir(folder.folder);
}

/// Refused without reading: opening a pipe would wait for a writer, and a device may be endless.
static void pipes_and_devices_are_refused(void** state) {
    (void)state;
    for (int k = 0; k < mesh_format_count; k++) {
        char name[32];
        snprintf(name, sizeof name, "mesh%s", mesh_format_table[k].extension);
        const TextFile pipe = write_bytes(name, "", 0);
        unlink(pipe.path);
        assert_int_equal(mkfifo(pipe.path, 0600), 0);
        refuse_path(pipe.path, "it is a pipe or a device");
        unlink(pipe.path);
        assert_int_equal(symlink("/dev/zero", pipe.path), 0);
        refuse_path(pipe.path, "it is a pipe or a device");
        remove_file(&pipe);
    }
}

static void capital_extension_is_an_obj_file(void** state) {
    (void)state;
    const char text[] = CUBE_POINTS CUBE_FACES;
    const TextFile file = write_bytes("MESH.OBJ", text, sizeof text - 1);
    Mesh mesh;
    load(file.path, &mesh);
    mesh_free(&mesh);
    remove_file(&file);
}

/// Far more groups and materials than assimp would take in a reasonable time.
static void many_groups_cost_nothing(void** state) {
    (void)state;
    enum { N = 20000 };
    char* text = NULL;
    size_t size = 0;
    FILE* out = open_memstream(&text, &size);
    for (int i = 0; i <= N; i++)
        fprintf(out, "v %d 0 0\nv %d 1 0\n", i, i);
    for (int i = 0; i < N; i++)
        fprintf(out, "o part%d\ng group%d\nusemtl color%d\nf %d %d %d %d\n", i, i, i, 2 * i + 1,
                2 * i + 3, 2 * i + 4, 2 * i + 2);
    fclose(out);
    Mesh mesh;
    const MeshReport report = load_good(text, &mesh);
    assert_int_equal(report.quads, N);
    for (int f = 0; f < N; f++)
        assert_true(mesh.point[mesh.face[f][0]][0] == f);
    free(text);
    mesh_free(&mesh);
}

/// A line continued again and again is read in linear time: quadratic, this would take minutes.
static void long_continued_lines_are_read(void** state) {
    (void)state;
    enum { N = 1000000 };
    char* text = NULL;
    size_t size = 0;
    FILE* out = open_memstream(&text, &size);
    fprintf(out, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2");
    for (int i = 0; i < N; i++)
        fprintf(out, " \\\n ");
    fprintf(out, "3\nf 1 2\n");
    fclose(out);
    Mesh mesh;
    MeshReport report;
    Fault fault = {0};
    assert_false(load_text(text, &mesh, &report, &fault));
    assert_non_null(strstr(fault.location, "mesh.obj:1000005"));
    free(text);
}

static void spot_has_its_counts(void** state) {
    (void)state;
    const char* const path = "../shared/meshes/spot_quads.obj";
    if (access(path, R_OK) != 0)
        skip();
    Mesh mesh;
    const MeshReport report = load(path, &mesh);
    assert_int_equal(report.points, 2930);
    assert_int_equal(report.quads, 2928);
    assert_int_equal(report.triangles, 0);
    assert_int_equal(report.genus, 0);
    assert_true(mesh.closed);
    mesh_free(&mesh);
}

/// Spot's control mesh has triangles, quads and 16 pentagons, the first of them in line 492.
static void pentagons_among_quads_are_refused(void** state) {
    (void)state;
    const char* const path = "../shared/meshes/spot_control_mixed.obj";
    if (access(path, R_OK) != 0)
        skip();
    Mesh mesh;
    MeshReport report;
    Fault fault = {0};
    assert_false(mesh_load(path, &mesh, &report, &fault));
    assert_non_null(strstr(fault.location, "spot_control_mixed.obj:492"));
    assert_non_null(strstr(fault.text, "face 37 has 5 corners"));
}

/// Change, remove or double a few bytes at random positions, with bytes that have a meaning in OBJ.
static size_t mutate(char* text, size_t size, Random* random) {
    static const char bytes[] = "vfplno 0123456789-+./#\\\n\r\tx\xff";
    for (int edits = 1 + (int)(4 * random_next(random)); edits > 0 && size > 1; edits--) {
        const size_t at = (size_t)((double)size * random_next(random));
        const double choice = random_next(random);
        if (choice < 0.6) {
            text[at] = bytes[(size_t)((sizeof bytes - 1) * random_next(random))];
        } else if (choice < 0.8) {
            memmove(text + at, text + at + 1, size - at - 1);
            size--;
        } else {
            memmove(text + at + 1, text + at, size - at);
            size++;
        }
    }
    return size;
}

/// Any bytes give a usable mesh or one sentence.
static void mutations_load_or_are_refused(void** state) {
    (void)state;
    const char complete[] = CUBE_POINTS CUBE_FACES "vt 0 0\nvn 1 0 0\nf 1/1/1 2/1/1 3/1/1\n"
                                                   "v 5 5 5\nf -1 -2 -3 \\\n -4\n";
    const TextFile file = write_bytes("mesh.obj", "", 0);
    Random random = {7};
    int usable = 0;
    for (int round = 0; round < 2000; round++) {
        char text[sizeof complete + 8];
        memcpy(text, complete, sizeof complete);
        const size_t full = round % 2 ? sizeof complete - 1 : sizeof CUBE_POINTS CUBE_FACES - 1;
        const size_t size = mutate(text, full, &random);
        FILE* out = fopen(file.path, "wb");
        fwrite(text, 1, size, out);
        fclose(out);

        Mesh mesh;
        MeshReport report;
        Fault fault = {0};
        const bool good = mesh_load(file.path, &mesh, &report, &fault);
        assert_true(good == (fault.text[0] == '\0'));
        usable += good;
        mesh_free(&mesh);
    }
    remove_file(&file);
    // some files must be usable, or only the first check would be tested
    assert_in_range(usable, 100, 1900);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(topology_is_exact_at_any_size_and_position),
        cmocka_unit_test(every_way_of_writing_is_understood),
        cmocka_unit_test(locale_does_not_matter),
        cmocka_unit_test(bad_lines_are_named),
        cmocka_unit_test(bad_files_are_named),
        cmocka_unit_test(pipes_and_devices_are_refused),
        cmocka_unit_test(capital_extension_is_an_obj_file),
        cmocka_unit_test(many_groups_cost_nothing),
        cmocka_unit_test(long_continued_lines_are_read),
        cmocka_unit_test(spot_has_its_counts),
        cmocka_unit_test(pentagons_among_quads_are_refused),
        cmocka_unit_test(mutations_load_or_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
