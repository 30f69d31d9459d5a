/// The spherical balloon in motion, against values computed by separate programs, against its
/// energy and its breathing. Golden numbers have the digits to which they were derived.
#include "truths.h"

/// A small swing is at its rest after a quarter, at its far side after a half of its period.
static void small_swings_have_the_breathing_frequency(void** state) {
    (void)state;
    const TruthBalloon b = truth_balloon_default();
    const double at_once = 1e-9; // [s]
    // of the empty skin under a small constant pressure, and of a closed gas of amount 1
    const double slow = PI / (2 * truth_breath_pressure(&b, 1)), fast = PI / (2 * 3245.381);
    const double rest = truth_stretch_pressure(&b, 0.01), full = truth_stretch_gas(&b, 1 + 1e-5);
    // the next term of the swing is its size squared, with a coefficient of some 10
    assert_near((truth_sudden(&b, 0.01, slow).l - rest) / (rest - 1), 0, 2e-5);
    assert_near((truth_sudden(&b, 0.01, 2 * slow).l - rest) / (rest - 1), 1, 2e-5);
    assert_near((truth_filling(&b, 1e-5, at_once, 0, fast).l - full) / (full - 1), 0, 2e-5);
    assert_near((truth_filling(&b, 1e-5, at_once, 0, 2 * fast).l - full) / (full - 1), 1, 2e-5);
}

static void sudden_pressure_moves_the_skin_as_computed(void** state) {
    (void)state;
    const TruthBalloon b = truth_balloon_default();
    assert_near(truth_sudden(&b, 800, 0.01).l, 1.1631942982, last(10));
    assert_near(truth_sudden(&b, 800, 0.02).l, 1.2025606445, last(10));
    // the furthest stretch, where the energy is all elastic, and the period, its integral of dl/l'
    const double furthest = 1.2266611128, period = 0.0144482699;
    assert_near(truth_sudden(&b, 800, period / 2).l, furthest, last(10));
    assert_near(truth_sudden(&b, 800, period).l, 1, 1e-11);
    assert_near(truth_sudden(&b, 800, period).speed, 0, 5e-6);
}

static void motion_keeps_its_energy(void** state) {
    (void)state;
    const double p = 800;
    for (int i = 0; i < truth_law_count; i++) {
        const TruthBalloon b = balloon_of(truth_law_table[i].name);
        const double inertia = b.density * b.radius * b.radius;
        for (double t = 0; t < 0.02; t += 0.0037) {
            const TruthMotion at = truth_sudden(&b, p, t);
            const double work = p * b.radius * (pow(at.l, 3) - 1) / (3 * b.thickness);
            const double kinetic = inertia * at.speed * at.speed / 2;
            assert_near(kinetic + b.law->energy(&b, at.l) - work, 0, 1e-9 * (1 + work));
        }
    }
}

static void a_large_step_of_pressure_runs_away(void** state) {
    (void)state;
    const TruthBalloon b = truth_balloon_default();
    // the maximum over l of 3 h0 W/(R0 (l^3-1)), the pressure whose work is all elastic at l
    const double limit = 1112.130006, furthest = 1.73166;
    assert_less(2, truth_sudden(&b, limit + 1, 0.05).l);
    assert_true(isinf(truth_sudden(&b, 5000, 1).l));
    // just below the limit it stays long near its largest stretch, and is not taken for unbounded
    for (double t = 0.01; t < 1; t *= 2) {
        assert_less(truth_sudden(&b, limit - 1, t).l, furthest);
        assert_less(truth_sudden(&b, limit - 0.13, t).l, furthest);
    }
}

static void slow_filling_moves_the_skin_as_computed(void** state) {
    (void)state;
    const TruthBalloon b = truth_balloon_default();
    assert_near(truth_filling(&b, 0.5, 0.01, 50, 0.01).l, 1.1377342335, last(10));
    assert_near(truth_filling(&b, 0.5, 0.01, 50, 0.02).l, 1.1444731146, last(10));
    assert_near(truth_filling(&b, 0.5, 0.01, 50, 0).l, 1, 0);
    // damping brings it to rest with its gas: e^(-25 * 1.5) is 5e-17
    assert_close(truth_filling(&b, 0.5, 0.01, 50, 1.5).l, truth_stretch_gas(&b, 1.5), 1e-10);
}

/// The same motion by `euler`: the expected errors of a run, of order 1.
static void euler_errors_of_the_sudden_pressure(void** state) {
    (void)state;
    const double want[] = {1.93e-2, 8.43e-3, 3.88e-3, 1.85e-3, 9.0e-4};
    const double digit[] = {5e-5, 5e-6, 5e-6, 5e-6, 5e-6};
    const TruthBalloon b = truth_balloon_default();
    for (int k = 0; k < 5; k++) {
        const double h = 1e-3 / (1 << k);
        double l = 1, speed = 0;
        for (int n = 0; n < 20 << k; n++) {
            const double push = 800 * b.radius * l * l / b.thickness - b.law->stress(&b, l);
            speed += h * push / (b.density * b.radius * b.radius);
            l += h * speed;
        }
        assert_near(fabs(l - truth_sudden(&b, 800, 0.02).l), want[k], digit[k]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_swings_have_the_breathing_frequency),
        cmocka_unit_test(sudden_pressure_moves_the_skin_as_computed),
        cmocka_unit_test(motion_keeps_its_energy),
        cmocka_unit_test(a_large_step_of_pressure_runs_away),
        cmocka_unit_test(slow_filling_moves_the_skin_as_computed),
        cmocka_unit_test(euler_errors_of_the_sudden_pressure),
    };
    return cmocka_run_group_tests_name("truth_radial", tests, NULL, NULL);
}
