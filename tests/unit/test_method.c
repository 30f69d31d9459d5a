/// What every method of the table owes: laws of motion, order, momenta, room.
#include "bodies.h"
#include "force/force.h"
#include "mesh/measure.h"

/// So many that each step is solved as far as the state's precision goes.
static const Solver thorough = {.iterations = 500, .tolerance = 1e-12, .linear_tolerance = 1e-3};

static bool takes(const Method* method, const Body* body) {
    return !method->refuses || !method->refuses(body);
}

/// Order 1 in its simplest form: after a time t every method is off g h t / 2, each to its side.
static void free_fall_is_off_by_half_a_step(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube", &mesh);
    const double h = 1.0 / 1024, t = 1.0 / 8;
    for (int m = 0; m < method_count; m++) {
        Body body;
        body_of(&mesh, &body);
        body.gravity = 9.81;
        if (method_table[m]->limit(1, 0) > 0) // `forward` would blow up from their rounding
            body_add_springs(&body, paper_springs, LAW_HOOKE);
        const double first = (double)body.x[0][1];
        steps_of(method_table[m], &body, &thorough, h, 128);
        // float: the sum of 128 roundings of positions of 1
        assert_near(fabs((double)body.x[0][1] - first + 9.81 * t * t / 2), 9.81 * h * t / 2,
                    TOLERANCE(1e-5, 1e-9));
        assert_close((double)body.v[0][1], -9.81 * t, TOLERANCE(1e-4, 1e-9));
        body_free(&body);
    }
    mesh_free(&mesh);
}

/// truth: 1 g on a spring of 50 N/m with drag 0.02, from 0.01 m.
static double damped_spring(const Method* method, double h) {
    Body body;
    chain_of(&body, (double[]){0, 1}, 2, 1e-3, 50);
    body.inverse_mass[0] = 0;
    body.damping.coefficient = 0.02;
    body.x[1][0] += (real)0.01;
    steps_of(method, &body, &thorough, h, (int)lround(0.05 / h));
    const double u = (double)body.x[1][0] - 1;
    body_free(&body);
    return u;
}

static void damped_spring_s_error_halves_with_the_step(void** state) {
    (void)state;
    for (int m = 0; m < method_count; m++) {
        double before = damped_spring(method_table[m], 2e-4) - 7.80094746935e-4;
        for (int k = 1; k < 4; k++) {
            const double now = damped_spring(method_table[m], 2e-4 / (1 << k)) - 7.80094746935e-4;
            // the next term is h w^2 / g of the first, 1/8 at most; float rounds 2,000 positions
            assert_near(before / now, 2, TOLERANCE(0.3, 0.15));
            before = now;
        }
    }
}

/// Springs and pressure alone move no middle of mass.
static void free_balloon_keeps_its_linear_momentum(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("torus:16x8", &mesh);
    for (int m = 0; m < method_count; m++)
        for (int law = INFLATE_AREA; law < INFLATION_LAWS; law++) {
            Body body;
            body_of(&mesh, &body);
            body_add_springs(&body, paper_springs, LAW_HOOKE);
            body_inflate(&body, &(Inflation){.law = (InflationLaw)law,
                                             .amount = law == INFLATE_GAS ? 1.8 : 5,
                                             .unit = 100,
                                             .ambient = 100,
                                             .temperature = 1});
            shake(&body, 0.02);
            for (int i = 0; i < body.count; i++)
                body.v[i] = (real4){(real)0.4, 0, (real)0.1, 0};
            if (!takes(method_table[m], &body))
                fail_msg("%s refuses springs", method_table[m]->name);
            steps_of(method_table[m], &body, &thorough, 5e-4, 200);
            double4 p = {0};
            double sum = 0;
            for (int i = 0; i < body.count; i++) {
                p += paper_mass * to_double4(body.v[i]);
                sum += paper_mass * (double)length(body.v[i]);
            }
            const double mass = paper_mass * body.count;
            // rounding of 200 steps; what a solver leaves is 1e-12 of the forces a step
            assert_near(p[0], 0.4 * mass, TOLERANCE(1e-4, 1e-9) * sum);
            assert_near(p[1], 0, TOLERANCE(1e-4, 1e-9) * sum);
            assert_near(p[2], 0.1 * mass, TOLERANCE(1e-4, 1e-9) * sum);
            body_free(&body);
        }
    mesh_free(&mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_fall_is_off_by_half_a_step),
        cmocka_unit_test(damped_spring_s_error_halves_with_the_step),
        cmocka_unit_test(free_balloon_keeps_its_linear_momentum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
