/// A written mesh is read back to the same bits, in loaded order.
#include "meshes.h"

#include "mesh/write.h"

static void what_is_written_is_read_back(void** state) {
    (void)state;
    const char* const names[] = {"cube-sphere:5", "icosphere:1", "torus:6x5", "disc:3x5"};
    for (int s = 0; s < 4; s++) {
        Mesh mesh, again;
        load(names[s], &mesh);
        real4* x = rest_state(&mesh);
        char* text = NULL;
        size_t size = 0;
        FILE* out = open_memstream(&text, &size);
        write_obj(&mesh, x, 0, out);
        fclose(out);

        load_good(text, &again);
        assert_int_equal(again.point_count, mesh.point_count);
        assert_int_equal(again.face_count, mesh.face_count);
        assert_memory_equal(again.face, mesh.face, (size_t)mesh.face_count * sizeof *mesh.face);
        for (int i = 0; i < mesh.point_count; i++)
            for (int k = 0; k < 3; k++)
                assert_true(again.point[i][k] == (double)x[i][k]);
        free(text);
        free(x);
        mesh_free(&mesh);
        mesh_free(&again);
    }
}

static void vertices_are_in_loaded_order(void** state) {
    (void)state;
    const char want[] = "v 3 0 0\nv 1 0 0\nv 2 1 0\nf 1 2 3\n";
    Mesh mesh;
    load_good("v 1 0 0\nv 2 1 0\nv 3 0 0\nf 3 1 2\n", &mesh);
    real4* x = rest_state(&mesh);
    char text[256] = "";
    FILE* out = fmemopen(text, sizeof text, "w");
    write_obj(&mesh, x, 0, out);
    fclose(out);
    assert_string_equal(text, want);
    free(x);
    mesh_free(&mesh);
}

/// Several skins in one file: the second one's vertex numbers follow the first one's.
static void skins_follow_each_other(void** state) {
    (void)state;
    Mesh mesh, both;
    load("cube:2", &mesh);
    real4* x = rest_state(&mesh);
    char* text = NULL;
    size_t size = 0;
    FILE* out = open_memstream(&text, &size);
    write_obj(&mesh, x, 0, out);
    for (int i = 0; i < mesh.point_count; i++)
        x[i] += (real4){5, 0, 0, 0};
    write_obj(&mesh, x, mesh.point_count, out);
    fclose(out);

    const MeshReport report = load_good(text, &both);
    assert_int_equal(report.components, 2);
    assert_int_equal(report.points, 2 * mesh.point_count);
    assert_close(report.volume, 16.0, 1e-15);
    free(text);
    free(x);
    mesh_free(&mesh);
    mesh_free(&both);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read_back),
        cmocka_unit_test(vertices_are_in_loaded_order),
        cmocka_unit_test(skins_follow_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
