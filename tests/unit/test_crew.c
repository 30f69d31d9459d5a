/// The thread pool runs every task once, and the bits do not depend on the number of threads.
#include "base/crew.h"
#include "bodies.h"
#include "force/damping.h"
#include "force/force.h"
#include "worlds.h"

enum { TASKS = 1000, THREADS = 5 };

static void count_task(void* self, int number) {
    ((int*)self)[number]++;
}

static void every_task_is_done_once(void** state) {
    (void)state;
    for (int threads = 1; threads <= THREADS; threads++) {
        crew_set(threads);
        int done[TASKS] = {0};
        for (int run = 0; run < 20; run++)
            crew_run(count_task, done, TASKS - run);
        for (int k = 0; k < TASKS - 20; k++)
            assert_int_equal(done[k], 20);
        crew_run(count_task, done, 0);
    }
    crew_set(1);
}

/// A task that runs tasks.
static void count_row(void* self, int number) {
    crew_run(count_task, (int(*)[TASKS])self + number, TASKS);
}

static void a_task_has_tasks_of_its_own(void** state) {
    (void)state;
    for (int threads = 1; threads <= THREADS; threads++) {
        crew_set(threads);
        int done[2 * THREADS][TASKS] = {{0}};
        crew_run(count_row, done, 2 * THREADS);
        for (int row = 0; row < 2 * THREADS; row++)
            for (int k = 0; k < TASKS; k++)
                assert_int_equal(done[row][k], 1);
    }
    crew_set(1);
}

/// Thirty balloons, divided among the threads.
static void balloons_are_shared_by_threads(void** state) {
    (void)state;
    uint64_t one = 0;
    for (int threads = 1; threads <= 3; threads++) {
        World world;
        WORLD_OF(&world, "crowd");
        assert_true(world.balloon_count >= 2 * threads);
        crew_set(threads);
        run_for(&world, 0.1);
        crew_set(1);
        if (threads == 1)
            one = world_hash(&world);
        assert_true(world_hash(&world) == one);
        world_close(&world);
    }
}

/// Some steps of springs, rubber and gas on a skin of many parts.
static void run_body(const Mesh* mesh, Body* body) {
    body_of(mesh, body);
    rubber_on(body, &material_neo_hookean, 0.01, 300, 1);
    body_add_springs(body, paper_springs, LAW_HOOKE);
    body_inflate(body, &(Inflation){.law = INFLATE_GAS,
                                    .amount = 1.5,
                                    .unit = 10,
                                    .ambient = 10,
                                    .temperature = 1,
                                    .filling = filling_table[0]});
    body->force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.02;
    shake(body, 0.005);
    steps_of(&method_euler, body, &(Solver){0}, 1e-4, 5);
}

static void any_number_of_threads_gives_the_same_bits(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:30", &mesh);
    Body one;
    run_body(&mesh, &one);
    assert_true(one.membrane.parts > 2 && one.slices.count > 2 * PART_SLICES);
    const size_t bytes = (size_t)one.count * sizeof(real4);
    const double bound = force_inflation.bound(&one);
    for (int threads = 2; threads <= THREADS; threads++) {
        Body other;
        crew_set(threads);
        run_body(&mesh, &other);
        assert_memory_equal(one.x, other.x, bytes);
        assert_memory_equal(one.v, other.v, bytes);
        assert_memory_equal(one.f, other.f, bytes);
        assert_true(force_inflation.bound(&other) == bound);
        crew_set(1);
        body_free(&other);
    }
    body_free(&one);
    mesh_free(&mesh);
}

/// Elements of different parts that run at the same time have no common particle.
static void parts_of_a_membrane_are_apart(void** state) {
    (void)state;
    const char* names[] = {"cube-sphere:30", "icosphere:5", "torus:200x20"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        Mesh mesh;
        Body body;
        mesh_of(names[n], &mesh);
        body_of(&mesh, &body);
        rubber_on(&body, &material_neo_hookean, 0.01, 300, 1);
        const Membrane* membrane = &body.membrane;
        int* last = new_array(int, body.count); // part that a particle was met in, of one parity
        for (int odd = 0; odd < 2; odd++) {
            for (int i = 0; i < body.count; i++)
                last[i] = NONE;
            for (int e = 0; e < membrane->count; e++) {
                int part = 0;
                while (membrane_part(membrane->eights, membrane->parts, part + 1) <= e / LANES)
                    part++;
                for (int c = 0; part % 2 == odd && c < 3; c++) {
                    int* met = &last[membrane->corner[e][c]];
                    assert_true(*met == NONE || *met == part);
                    *met = part;
                }
            }
        }
        free(last);
        body_free(&body);
        mesh_free(&mesh);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_task_is_done_once),
        cmocka_unit_test(a_task_has_tasks_of_its_own),
        cmocka_unit_test(balloons_are_shared_by_threads),
        cmocka_unit_test(any_number_of_threads_gives_the_same_bits),
        cmocka_unit_test(parts_of_a_membrane_are_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
