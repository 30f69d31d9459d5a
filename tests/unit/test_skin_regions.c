/// Regions of a skin that are unfolded: nothing of them crosses, and a smooth skin is all of them.
#include "bodies.h"
#include "contact/skins/crossings.h"
#include "contact/skins/skin_regions.h"

static void open_skin(const char* model, Mesh* mesh, Body* body, SkinRegions* regions) {
    mesh_of(model, mesh);
    body_of(mesh, body);
    skin_regions_open(regions, body);
}

static void close_skin(Mesh* mesh, Body* body, SkinRegions* regions) {
    skin_regions_close(regions);
    body_free(body);
    mesh_free(mesh);
}

static void a_smooth_skin_is_all_unfolded(void** state) {
    (void)state;
    const char* const model[] = {"cube-sphere:16", "icosphere:4", "grid:10x10"};
    for (int m = 0; m < 3; m++) {
        Mesh mesh;
        Body body;
        SkinRegions regions;
        open_skin(model[m], &mesh, &body, &regions);
        assert_int_equal(skin_regions_leave_out(&regions, &body), regions.count);
        int triangles = 0;
        for (int p = 0; p < regions.count; p++) {
            assert_true(skin_regions_cover(&regions, p, p));
            triangles += regions.from[p + 1] - regions.from[p];
        }
        assert_int_equal(triangles, mesh.triangle_count);
        close_skin(&mesh, &body, &regions);
    }
}

/// Crossing pairs of triangles of one skin: of regions left out, and all.
static int crossings_covered(const SkinRegions* regions, const Body* body, int* all) {
    int covered = 0;
    *all = 0;
    for (int t = 0; t < body->mesh->triangle_count; t++)
        for (int u = t + 1; u < body->mesh->triangle_count; u++)
            if (length(body->x[body->mesh->triangle[t][0]] - body->x[body->mesh->triangle[u][0]]) <
                    1 && // no edge is half as long
                crossing_of(body, t, body, u)) {
                (*all)++;
                covered += skin_regions_cover(regions, regions->patch[t], regions->patch[u]);
            }
    return covered;
}

/// One side of a skin is crumpled more and more, until much of it crosses.
static void what_is_left_out_never_crosses(void** state) {
    (void)state;
    enum { ROUNDS = 10 };
    const char* const model[] = {"cube-sphere:12", "grid:16x16"};
    for (int m = 0; m < 2; m++) {
        Mesh mesh;
        Body body;
        SkinRegions regions;
        open_skin(model[m], &mesh, &body, &regions);
        Random random = {(uint64_t)m + 1};
        int crossings = 0, left_out = 0;
        for (int n = 0; n < ROUNDS; n++) {
            const double amplitude = 0.02 * n * body.size / 2;
            for (int i = 0; i < body.count; i++)
                for (int c = 0; c < 3; c++)
                    body.x[i][c] +=
                        (real)((body.x[i][0] > 0) * amplitude * (random_next(&random) - 0.5));
            for (int i = 0; i < body.count; i++)
                body.x[i][n % 3] *= (real)0.97;
            int all;
            const int some = skin_regions_leave_out(&regions, &body);
            assert_int_equal(crossings_covered(&regions, &body, &all), 0);
            crossings += all;
            left_out += all > 0 ? some : 0;
            // what is left out already may be less sure, and must not cross either
            memcpy(regions.x, body.x, (size_t)body.count * sizeof *body.x);
            assert_true(skin_regions_hold(&regions, &mesh));
        }
        assert_true(crossings > 0 && left_out > 0);
        close_skin(&mesh, &body, &regions);
    }
}

/// A fold turns triangles over: its regions are no longer left out.
static void a_fold_is_found(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    SkinRegions regions;
    open_skin("grid:10x10", &mesh, &body, &regions);
    assert_int_equal(skin_regions_leave_out(&regions, &body), regions.count);
    double middle = 0;
    for (int i = 0; i < body.count; i++)
        middle += (double)body.x[i][0] / body.count;
    for (int i = 0; i < body.count; i++) {
        regions.x[i] = body.x[i];
        regions.x[i][0] = (real)(middle + fabs((double)body.x[i][0] - middle));
    }
    assert_false(skin_regions_hold(&regions, &mesh));
    assert_true(regions.any_failed);
    // they are not left out the next time, though the skin is flat now
    assert_true(skin_regions_leave_out(&regions, &body) < regions.count);
    assert_int_equal(skin_regions_leave_out(&regions, &body), regions.count);
    close_skin(&mesh, &body, &regions);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_smooth_skin_is_all_unfolded),
        cmocka_unit_test(what_is_left_out_never_crosses),
        cmocka_unit_test(a_fold_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
