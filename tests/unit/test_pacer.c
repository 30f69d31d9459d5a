/// The pacer: wall time only decides how many steps.
#include "law.h"

#include "show/pacer.h"

static const double frame = 1.0 / 60;

static void steps_add_up_to_the_time_that_passed(void** state) {
    (void)state;
    Pacer pacer = pacer_make(0.002, INFINITY);
    long sum = 0;
    for (int k = 1; k <= 6000; k++) {
        sum += pacer_due(&pacer, frame);
        assert_int_equal(sum, k * 25 / 3); // floor(k / (60 * 0.002))
    }
}

static void a_step_longer_than_a_frame_waits(void** state) {
    (void)state;
    Pacer pacer = pacer_make(0.05, INFINITY);
    assert_int_equal(pacer_due(&pacer, 0.03), 0);
    assert_int_equal(pacer_due(&pacer, 0.03), 1);
    assert_int_equal(pacer_due(&pacer, 0.03), 0);
    assert_int_equal(pacer_due(&pacer, 0.03), 1);
}

static void a_hitch_is_forgotten(void** state) {
    (void)state;
    Pacer pacer = pacer_make(0.01, 0.05);
    assert_int_equal(pacer_due(&pacer, 10), 5);
    assert_int_equal(pacer_due(&pacer, 0.01), 1);
    assert_int_equal(pacer_due(&pacer, -3), 0); // the clock was set back
    assert_int_equal(pacer_due(&pacer, 0.01), 1);
}

static void slow_motion_stretches_time(void** state) {
    (void)state;
    Pacer pacer = pacer_make(0.002, INFINITY);
    for (int k = 0; k < 10; k++)
        pacer_slower(&pacer);
    assert_int_equal(pacer.slowdown, PACER_SLOWEST);

    long sum = 0;
    for (int k = 0; k < 600; k++)
        sum += pacer_due(&pacer, frame);
    assert_int_equal(sum, 312); // floor(10 / 16 / 0.002)

    for (int k = 0; k < 10; k++)
        pacer_faster(&pacer);
    assert_int_equal(pacer.slowdown, 1);
}

static void paused_only_single_steps_are_due(void** state) {
    (void)state;
    Pacer pacer = pacer_make(0.002, INFINITY);
    pacer.paused = true;
    assert_int_equal(pacer_due(&pacer, 1), 0);
    pacer.single = 2;
    assert_int_equal(pacer_due(&pacer, 1), 2);
    assert_int_equal(pacer_due(&pacer, 1), 0);

    // the time of the pause is not made up
    pacer.paused = false;
    assert_int_equal(pacer_due(&pacer, 0.004), 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_add_up_to_the_time_that_passed),
        cmocka_unit_test(a_step_longer_than_a_frame_waits),
        cmocka_unit_test(a_hitch_is_forgotten),
        cmocka_unit_test(slow_motion_stretches_time),
        cmocka_unit_test(paused_only_single_steps_are_due),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
