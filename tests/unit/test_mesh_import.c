/// Formats that assimp reads: topology restored from each, transforms applied, and a sentence for
/// each file that cannot be read, however damaged.
#include "meshes.h"

typedef struct Format {
    const char* file;
    bool quads; ///< else each face is two triangles
    void (*write)(const Mesh* mesh, FILE* out);
} Format;

static void write_floats(FILE* out, double4 p) {
    const float f[3] = {(float)p[0], (float)p[1], (float)p[2]};
    fwrite(f, sizeof *f, 3, out);
}

static void write_stl_text(const Mesh* mesh, FILE* out) {
    fprintf(out, "solid skin\n");
    for (int t = 0; t < mesh->triangle_count; t++) {
        fprintf(out, "facet normal 0 0 0\nouter loop\n");
        for (int k = 0; k < 3; k++) {
            const double4 p = mesh->point[mesh->triangle[t][k]];
            fprintf(out, "vertex %.9g %.9g %.9g\n", p[0], p[1], p[2]);
        }
        fprintf(out, "endloop\nendfacet\n");
    }
    fprintf(out, "endsolid skin\n");
}

static void write_stl_binary(const Mesh* mesh, FILE* out) {
    const char header[80] = "binary";
    fwrite(header, 1, sizeof header, out);
    fwrite(&mesh->triangle_count, 4, 1, out);
    for (int t = 0; t < mesh->triangle_count; t++) {
        write_floats(out, (double4){0});
        for (int k = 0; k < 3; k++)
            write_floats(out, mesh->point[mesh->triangle[t][k]]);
        fwrite("\0", 1, 2, out);
    }
}

static void write_off(const Mesh* mesh, FILE* out) {
    fprintf(out, "OFF\n# points, faces, edges\n%d %d %d\n", mesh->point_count, mesh->face_count,
            mesh->edge_count);
    for (int i = 0; i < mesh->point_count; i++)
        fprintf(out, "%.9g %.9g %.9g\n", mesh->point[i][0], mesh->point[i][1], mesh->point[i][2]);
    for (int f = 0; f < mesh->face_count; f++) {
        const int* c = mesh->face[f];
        if (c[3] == NONE)
            fprintf(out, "3 %d %d %d\n", c[0], c[1], c[2]);
        else
            fprintf(out, "4 %d %d %d %d\n", c[0], c[1], c[2], c[3]);
    }
}

/// Positions, then triangles as 32-bit indices.
static void write_gltf_buffer(const Mesh* mesh, FILE* out) {
    for (int i = 0; i < mesh->point_count; i++)
        write_floats(out, mesh->point[i]);
    fwrite(mesh->triangle, sizeof *mesh->triangle, (size_t)mesh->triangle_count, out);
}

static char* gltf_json(const Mesh* mesh, const char* uri, const char* nodes) {
    const int points = 12 * mesh->point_count, triangles = 12 * mesh->triangle_count;
    char* text = NULL;
    size_t size = 0;
    FILE* out = open_memstream(&text, &size);
    fprintf(out,
            "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
            "\"nodes\":[%s],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},"
            "\"indices\":1}]}],\"buffers\":[{%s\"byteLength\":%d}],"
            "\"bufferViews\":[{\"buffer\":0,\"byteLength\":%d},"
            "{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":%d}],"
            "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%d,"
            "\"type\":\"VEC3\"},{\"bufferView\":1,\"componentType\":5125,\"count\":%d,"
            "\"type\":\"SCALAR\"}]}",
            nodes, uri, points + triangles, points, points, triangles, mesh->point_count,
            3 * mesh->triangle_count);
    while (ftell(out) % 4) // a chunk of a GLB file is of complete words
        fputc(' ', out);
    fclose(out);
    return text;
}

static void write_glb_nodes(const Mesh* mesh, const char* nodes, FILE* out) {
    char* json = gltf_json(mesh, "", nodes);
    const uint32_t json_bytes = (uint32_t)strlen(json);
    const uint32_t buffer_bytes = 12 * (uint32_t)(mesh->point_count + mesh->triangle_count);
    const uint32_t header[2] = {2, 12 + 8 + json_bytes + 8 + buffer_bytes};
    fwrite("glTF", 1, 4, out);
    fwrite(header, 4, 2, out);
    fwrite(&json_bytes, 4, 1, out);
    fwrite("JSON", 1, 4, out);
    fwrite(json, 1, json_bytes, out);
    fwrite(&buffer_bytes, 4, 1, out);
    fwrite("BIN\0", 1, 4, out);
    write_gltf_buffer(mesh, out);
    free(json);
}

static void write_glb(const Mesh* mesh, FILE* out) {
    write_glb_nodes(mesh, "{\"mesh\":0}", out);
}

static const Format formats[] = {
    {"text.stl", false, write_stl_text},
    {"BINARY.STL", false, write_stl_binary},
    {"mesh.off", true, write_off},
    {"mesh.glb", false, write_glb},
};
enum { FORMATS = sizeof formats / sizeof *formats };

/// The bytes of the mesh in this format, freed with free().
static char* bytes_of(const Format* format, const Mesh* mesh, size_t* size) {
    char* bytes = NULL;
    FILE* out = open_memstream(&bytes, size);
    format->write(mesh, out);
    fclose(out);
    return bytes;
}

static MeshReport load_bytes(const char* name, const char* bytes, size_t size, Mesh* mesh) {
    const TextFile file = write_bytes(name, bytes, size);
    const MeshReport report = load(file.path, mesh);
    remove_file(&file);
    return report;
}

/// The same skin, in single precision; with a quad's triangles where the format has no quads.
static void check_skin(const MeshReport* got, const MeshReport* want, const Mesh* mesh,
                       bool quads) {
    const int faces = quads ? mesh->face_count : mesh->triangle_count;
    assert_int_equal(got->points, want->points);
    assert_int_equal(got->quads + got->triangles, faces);
    assert_int_equal(got->components, want->components);
    assert_int_equal(got->genus, want->genus);
    assert_int_equal(got->rims, want->rims);
    assert_int_equal(got->flipped_faces, 0);
    // a flat triangle of a curved quad encloses another volume: about one face's size squared
    assert_close(got->volume, want->volume, quads ? 1e-6 : 0.01);
}

static void every_format_restores_the_topology(void** state) {
    (void)state;
    static const char* const shapes[] = {"cube", "torus:24x12", "icosphere:3", "disc:6x12"};
    for (int s = 0; s < 4; s++) {
        for (int f = 0; f < FORMATS; f++) {
            Mesh mesh, read;
            const MeshReport want = load(shapes[s], &mesh);
            size_t size;
            char* bytes = bytes_of(&formats[f], &mesh, &size);
            const MeshReport got = load_bytes(formats[f].file, bytes, size, &read);
            check_skin(&got, &want, &mesh, formats[f].quads);
            free(bytes);
            mesh_free(&mesh);
            mesh_free(&read);
        }
    }
}

/// The buffer of a glTF file is a file beside it.
static void gltf_finds_its_buffer(void** state) {
    (void)state;
    Mesh mesh, read;
    const MeshReport want = load("torus", &mesh);
    char* json = gltf_json(&mesh, "\"uri\":\"mesh.bin\",", "{\"mesh\":0}");
    const TextFile file = write_bytes("mesh.gltf", json, strlen(json));
    char path[64];
    snprintf(path, sizeof path, "%s/mesh.bin", file.folder);
    FILE* out = fopen(path, "wb");
    write_gltf_buffer(&mesh, out);
    fclose(out);
    const MeshReport got = load(file.path, &read);
    check_skin(&got, &want, &mesh, false);
    unlink(path);
    remove_file(&file);
    free(json);
    mesh_free(&mesh);
    mesh_free(&read);
}

/// Scales by 2 and by 3, moves by 10: nodes multiply, and a mesh may be shown twice.
static void transforms_of_the_scene_are_applied(void** state) {
    (void)state;
    Mesh cube, read;
    load("cube", &cube);
    const char nodes[] = "{\"children\":[1,2],\"scale\":[2,2,2]},{\"mesh\":0},"
                         "{\"mesh\":0,\"translation\":[10,0,0],\"scale\":[3,3,3]}";
    char* bytes = NULL;
    size_t size;
    FILE* out = open_memstream(&bytes, &size);
    write_glb_nodes(&cube, nodes, out);
    fclose(out);
    const MeshReport report = load_bytes("mesh.glb", bytes, size, &read);
    assert_int_equal(report.components, 2);
    assert_int_equal(report.points, 16);
    assert_close(report.volume, 8.0 * (8 + 216), 1e-12);
    double right = 0;
    for (int i = 0; i < read.point_count; i++)
        right = fmax(right, read.point[i][0]);
    assert_true(right == 2 * (10 + 3));
    free(bytes);
    mesh_free(&cube);
    mesh_free(&read);
}

/// Points are joined by index, not by location: these two touch in a point and stay separate.
static void coincident_vertices_stay_apart(void** state) {
    (void)state;
    const char text[] =
        "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 3 4 5\n";
    Mesh mesh;
    const MeshReport report = load_bytes("mesh.off", text, sizeof text - 1, &mesh);
    assert_int_equal(report.points, 6);
    assert_int_equal(report.components, 2);
    mesh_free(&mesh);
}

static void bad_files_are_refused(void** state) {
    (void)state;
    // clang-format off
    static const char* const cases[][3] = {
        {"a.off", "OFF\n5 1 0\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n5 0 1 2 3 4\n", "face 1 has 5 corners"},
        {"b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\nnan 1 0\n3 0 1 2\n", "not finite"},
        {"c.off", "OFF\n300000000 1 0\n0 0 0\n", "announces more than it can hold"},
        {"d.off", "OFF\n3 99999999999999999999 0\n0 0 0\n", "announces more than it can hold"},
        {"e.off", "OFF\n3\n", "three counts begin it"},
        {"f.off", "v 0 0 0\n", "assimp cannot read it"},
        {"g.stl", "solid\n", "assimp cannot read it"},
        {"h.stl", "", "is empty"},
        {"i.glb", "glTF\2", "is not a GLB file"},
        {"j.glb", "glTF\2\2\2\2xxxxxxxxJSON{}", "announces more than it can hold"},
        {"k.gltf", "{}", "assimp cannot read it"},
        {"l.dae", "<COLLADA/>", "is not a mesh file"},
    };
    // clang-format on
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const TextFile file = write_bytes(cases[i][0], cases[i][1], strlen(cases[i][1]));
        Mesh mesh;
        Fault fault = {0};
        MeshReport report;
        assert_false(mesh_load(file.path, &mesh, &report, &fault));
        assert_string_equal(fault.location, file.path);
        if (!strstr(fault.text, cases[i][2]))
            fail_msg("%s: got \"%s\", want \"%s\"", cases[i][0], fault.text, cases[i][2]);
        remove_file(&file);
    }
}

/// Cut off, or with a few bytes changed.
static size_t damage(char* bytes, size_t size, Random* random) {
    if (random_next(random) < 0.3)
        return (size_t)((double)size * random_next(random));
    for (int edits = 1 + (int)(4 * random_next(random)); edits > 0; edits--)
        bytes[(size_t)((double)size * random_next(random))] =
            (char)(unsigned char)(256 * random_next(random));
    return size;
}

/// Any bytes give a usable mesh or one sentence.
static void damaged_files_load_or_are_refused(void** state) {
    (void)state;
    Mesh cube;
    load("cube", &cube);
    for (int f = 0; f < FORMATS; f++) {
        size_t full;
        char* complete = bytes_of(&formats[f], &cube, &full);
        char* bytes = new_array(char, full);
        const TextFile file = write_bytes(formats[f].file, "", 0);
        Random random = {11};
        int usable = 0;
        for (int round = 0; round < 500; round++) {
            memcpy(bytes, complete, full);
            const size_t size = damage(bytes, full, &random);
            FILE* out = fopen(file.path, "wb");
            fwrite(bytes, 1, size, out);
            fclose(out);
            Mesh mesh;
            Fault fault = {0};
            MeshReport report;
            const bool good = mesh_load(file.path, &mesh, &report, &fault);
            assert_true(good == (fault.text[0] == '\0'));
            usable += good;
            mesh_free(&mesh);
        }
        // some files must be usable, or only the first check would be tested
        assert_in_range(usable, 10, 490);
        remove_file(&file);
        free(complete);
        free(bytes);
    }
    mesh_free(&cube);
}

/// A glTF file of a cube's mesh below so many nodes: each lists the next one `times` times.
static char* nested_gltf(int depth, int times) {
    Mesh cube;
    load("cube", &cube);
    char* nodes = NULL;
    size_t size;
    FILE* out = open_memstream(&nodes, &size);
    for (int k = 1; k <= depth; k++) {
        fprintf(out, "{\"children\":[%d", k);
        for (int t = 1; t < times; t++)
            fprintf(out, ",%d", k);
        fprintf(out, "]},");
    }
    fprintf(out, "{\"mesh\":0}");
    fclose(out);
    char* json = gltf_json(&cube, "\"uri\":\"mesh.bin\",", nodes);
    free(nodes);
    mesh_free(&cube);
    return json;
}

/// Files that exhaust assimp's stack or memory, or block it, end only the child process.
static void hostile_files_are_refused(void** state) {
    (void)state;
    for (int k = 0; k < 3; k++) {
#ifdef __SANITIZE_ADDRESS__
        if (k == 1)
            continue; // the sanitizer's own memory cannot be limited
#endif
        char* json = nested_gltf(k == 0 ? 20000 : k == 1 ? 24 : 1, k == 1 ? 2 : 1);
        const TextFile file = write_bytes("mesh.gltf", json, strlen(json));
        char path[64];
        snprintf(path, sizeof path, "%s/mesh.bin", file.folder);
        if (k == 2)
            assert_int_equal(symlink("/dev/zero", path), 0); // an external buffer without an end
        Mesh mesh;
        MeshReport report;
        Fault fault = {0};
        assert_false(mesh_load(file.path, &mesh, &report, &fault));
        assert_string_equal(fault.location, file.path);
        assert_true(fault.text[0] != '\0');
        unlink(path);
        remove_file(&file);
        free(json);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_restores_the_topology),
        cmocka_unit_test(gltf_finds_its_buffer),
        cmocka_unit_test(transforms_of_the_scene_are_applied),
        cmocka_unit_test(coincident_vertices_stay_apart),
        cmocka_unit_test(bad_files_are_refused),
        cmocka_unit_test(hostile_files_are_refused),
        cmocka_unit_test(damaged_files_load_or_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
