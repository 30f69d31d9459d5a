/// Batches of springs contain each spring once, and no particle twice.
#include "bodies.h"
#include "solve/batch/batches.h"

static void check(const char* name) {
    Mesh mesh;
    Body body;
    Batches batches;
    mesh_of(name, &mesh);
    body_of(&mesh, &body);
    body_add_springs(&body, paper_springs, LAW_HOOKE);
    batches_make(&batches, &body.springs, body.count);
    int* seen = new_array(int, body.springs.count);
    int all = 0;
    for (int b = 0; b < batches.count; b++) {
        assert_in_range(batches.filled[b], 1, LANES);
        for (int k = 0; k < batches.filled[b]; k++) {
            const int* end = body.springs.end[batches.spring[b][k]];
            seen[batches.spring[b][k]]++;
            all++;
            for (int other = 0; other < k; other++) {
                const int* its = body.springs.end[batches.spring[b][other]];
                assert_true(end[0] != its[0] && end[0] != its[1] && end[1] != its[0] &&
                            end[1] != its[1]);
            }
        }
    }
    assert_int_equal(all, body.springs.count);
    for (int s = 0; s < body.springs.count; s++)
        assert_int_equal(seen[s], 1);
    // a skin of any size fills nearly all lanes
    if (body.springs.count > 1000)
        assert_less((double)batches.count * LANES, 1.05 * body.springs.count);
    free(seen);
    batches_free(&batches);
    body_free(&body);
    mesh_free(&mesh);
}

static void no_batch_has_a_particle_twice(void** state) {
    (void)state;
    const char* names[] = {"cube",      "disc:1x3",       "pillow:3",
                           "torus:9x7", "cube-sphere:16", "assets/models/squirrel.obj"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        check(names[k]);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_batch_has_a_particle_twice)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
