/// Provot's and Tarantino's corrections.
#include "bodies.h"
#include "constraint/strain_limit.h"
#include "force/damping.h"
#include "force/force.h"
#include "solve/method.h"

static double length_of(const Body* body, int s) {
    const int* end = body->springs.end[s];
    return (double)length(body->x[end[1]] - body->x[end[0]]);
}

/// A drift with the corrected velocities ends at the corrected positions.
static void go(StrainLimit* correct, Body* body, double h) {
    strain_limit_velocity(correct, body, h, h);
    body_drift(body, h);
}

static void long_spring_comes_back_to_its_limit(void** state) {
    (void)state;
    Body body;
    StrainLimit correct = {.threshold = {0.1, 0, 0}};
    chain_of(&body, (double[]){0, 1}, 2, 1, 10);
    strain_limit_switch(&correct, &body, true);
    body.v[1][0] = 1;
    go(&correct, &body, 0.5); // would be at 1.5

    // half each, and the velocity is the actual displacement over h
    const double rounding = TOLERANCE(1e-6, 1e-15);
    assert_near(length_of(&body, 0), 1.1, rounding);
    assert_near((double)body.x[0][0], 0.2, rounding);
    assert_near((double)body.v[0][0], 0.2 / 0.5, rounding);
    assert_near((double)body.v[1][0], 0.3 / 0.5, rounding);
    assert_int_equal(correct.corrected, 1);
    strain_limit_free(&correct);
    body_free(&body);
}

static void held_end_stays_and_free_end_takes_all(void** state) {
    (void)state;
    Body body;
    StrainLimit correct = {.threshold = {0.1, 0, 0}};
    chain_of(&body, (double[]){0, 1}, 2, 1, 10);
    body.inverse_mass[0] = 0;
    strain_limit_switch(&correct, &body, true);
    body.v[1][0] = 2;
    go(&correct, &body, 1);
    assert_near((double)body.x[0][0], 0, 0);
    assert_near((double)body.x[1][0], 1.1, TOLERANCE(1e-6, 1e-15));
    strain_limit_free(&correct);
    body_free(&body);
}

static void short_enough_springs_are_left_alone(void** state) {
    (void)state;
    Body body;
    StrainLimit correct = {.threshold = {0.1, 0, 0}};
    chain_of(&body, (double[]){0, 1, 2}, 3, 1, 10);
    strain_limit_switch(&correct, &body, true);
    body.v[2][0] = (real)0.0625;
    go(&correct, &body, 1);
    assert_near((double)body.x[2][0], 2.0625, 0);
    assert_near((double)body.v[2][0], 0.0625, 0);
    assert_int_equal(correct.corrected, 0);
    strain_limit_free(&correct);
    body_free(&body);
}

/// A correction between free ends keeps the center of mass.
static void pull_keeps_the_center_of_mass(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    StrainLimit correct = {.threshold = {0.1, 0.1, 0.1}};
    mesh_of("cube-sphere:5", &mesh);
    body_of(&mesh, &body);
    body_add_springs(&body, paper_springs, LAW_HOOKE);
    strain_limit_switch(&correct, &body, true);
    shake(&body, 0.2);
    double4 before = {0}, after = {0};
    for (int i = 0; i < body.count; i++)
        before += to_double4(body.x[i]);
    go(&correct, &body, 1);
    for (int i = 0; i < body.count; i++)
        after += to_double4(body.x[i]);
    assert_true(correct.corrected > 10);
    assert_near(dlength(after - before), 0, TOLERANCE(1e-4, 1e-13));
    strain_limit_free(&correct);
    body_free(&body);
    mesh_free(&mesh);
}

static void tarantino_rests_a_corrected_spring_for_one_step(void** state) {
    (void)state;
    Body body;
    StrainLimit correct = {.threshold = {0.1, 0, 0}, .tarantino = true};
    chain_of(&body, (double[]){0, 1, 2}, 3, 1, 10);
    strain_limit_switch(&correct, &body, true);
    body.v[2][0] = 1;
    go(&correct, &body, 1);
    assert_near((double)body.springs.active[0], 10, 0);
    assert_near((double)body.springs.active[1], 0, 0);

    // below its limit the force acts again in the next step
    body.v[1][0] = body.v[2][0] = 0;
    body.x[1][0] = 1;
    body.x[2][0] = (real)2.05;
    go(&correct, &body, 1);
    assert_near((double)body.springs.active[1], 10, 0);

    body.v[2][0] = 1;
    go(&correct, &body, 1);
    assert_near((double)body.springs.active[1], 0, 0);
    strain_limit_switch(&correct, &body, false);
    assert_near((double)body.springs.active[1], 10, 0);
    strain_limit_free(&correct);
    body_free(&body);
}

/// An inflated sphere stretches less with correction than without, at most by about the threshold.
static double blown_stretch(bool on) {
    Mesh mesh;
    Body body;
    StrainLimit correct = {.threshold = {0.1, 0.1, 0.1}};
    mesh_of("cube-sphere:6", &mesh);
    body_of(&mesh, &body);
    body_add_springs(&body, paper_springs, LAW_HOOKE);
    body_inflate(&body, &(Inflation){.law = INFLATE_AREA, .amount = 20});
    body.force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.05;
    strain_limit_switch(&correct, &body, on);
    for (int n = 0; n < 3000; n++) {
        method_euler.kick_body(&body, NULL, 1e-3, &(SolveStats){0});
        strain_limit_velocity(&correct, &body, 1e-3, 1e-3);
        body_drift(&body, 1e-3);
    }
    double mean = 0;
    for (int s = 0; s < body.springs.from[SHEAR]; s++)
        mean += length_of(&body, s) / (double)body.springs.rest[s] / body.springs.from[SHEAR];
    strain_limit_free(&correct);
    body_free(&body);
    mesh_free(&mesh);
    return mean;
}

static void correction_constrains_a_blown_up_balloon(void** state) {
    (void)state;
    assert_less(blown_stretch(true), 1.12);
    assert_less(1.3, blown_stretch(false));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_spring_comes_back_to_its_limit),
        cmocka_unit_test(held_end_stays_and_free_end_takes_all),
        cmocka_unit_test(short_enough_springs_are_left_alone),
        cmocka_unit_test(pull_keeps_the_center_of_mass),
        cmocka_unit_test(tarantino_rests_a_corrected_spring_for_one_step),
        cmocka_unit_test(correction_constrains_a_blown_up_balloon),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
