/// Memory: no method allocates in a step.
#include "worlds.h"

#include <suitesparse/SuiteSparse_config.h>

// the Makefile links this test with these functions in front of the C library's
void* __real_malloc(size_t size);
void* __real_calloc(size_t count, size_t size);
void* __real_realloc(void* old, size_t size);
void* __real_aligned_alloc(size_t alignment, size_t size);
void* __wrap_malloc(size_t size);
void* __wrap_calloc(size_t count, size_t size);
void* __wrap_realloc(void* old, size_t size);
void* __wrap_aligned_alloc(size_t alignment, size_t size);
static int allocations;

void* __wrap_malloc(size_t size) {
    allocations++;
    return __real_malloc(size);
}

void* __wrap_calloc(size_t count, size_t size) {
    allocations++;
    return __real_calloc(count, size);
}

void* __wrap_realloc(void* old, size_t size) {
    allocations++;
    return __real_realloc(old, size);
}

void* __wrap_aligned_alloc(size_t alignment, size_t size) {
    allocations++;
    return __real_aligned_alloc(alignment, size);
}

/// A step allocates nothing, and CHOLMOD nothing after it has factored the matrix.
static void step_allocates_nothing(void** state) {
    (void)state;
    SuiteSparse_config.malloc_func = malloc;
    SuiteSparse_config.calloc_func = calloc;
    SuiteSparse_config.realloc_func = realloc;
    for (int m = 0; m < method_count; m++) {
        char method[64];
        snprintf(method, sizeof method, "method=%s", method_table[m]->name);
        World world;
        WORLD_OF(
            &world, "cube-sphere:6", method, "guard=off",
            "balloons.0.strain_limit={structural: 0.1, shear: 0.1, flexion: 0.1, tarantino: true}",
            "balloons.0.inflation.law=gas", "balloons.0.inflation.ambient=100");
        assert_true(allocations > 0);
        int factored = 0;
        for (int n = 0; n < 100; n++) {
            const int before = allocations;
            world_step(&world);
            if (world.balloon[0].stats.factored)
                factored++;
            else
                assert_int_equal(allocations, before);
        }
        assert_true(factored <= 1);
        world_close(&world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(step_allocates_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
