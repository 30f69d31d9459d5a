/// The closed forms of particles, sheets of springs and two sewn discs, and the limits of the
/// methods, against values computed by separate programs and against the methods' steps of one
/// oscillator.
#include "truths.h"

#include "solve/method.h"

/// x after n steps of `euler` under x'' = push - w2 x - gamma x', and its speed in *v.
static double euler(double w2, double gamma, double push, double x, double* v, double h, int n) {
    for (int i = 0; i < n; i++) {
        *v += h * (push - w2 * x - gamma * *v);
        x += h * *v;
    }
    return x;
}

// --- particles ---------------------------------------------------------------------------------

/// A cube of w^2 = 50/1e-3 and gamma = 0.02/1e-3 as a damped spring, at rest at 0.01: x(t).
static double spring(double t) {
    const TruthCube cube = {.side = 2, .structural = 25, .mass = 1e-3, .drag = 0.02, .amount = 1};
    return 0.01 * (1 - truth_cube_growth(&cube, t) / (truth_cube_rest(&cube) - sqrt(3)));
}

static void damped_spring_is_where_computed(void** state) {
    (void)state;
    const double w2 = 50 / 1e-3, gamma = 0.02 / 1e-3, t = 0.05;
    const double x = spring(t);
    assert_near(x, 7.80094746935e-4, last(15));
    // the expected errors of a run by `euler`
    const double want[] = {1.0122e-4, 5.0279e-5, 2.5056e-5}, digit[] = {1e-8, 1e-9, 1e-9};
    for (int k = 0; k < 3; k++) {
        double v = 0;
        const double got = euler(w2, gamma, 0, 0.01, &v, 1e-4 / (1 << k), 500 << k);
        assert_near(fabs(got - x), want[k], 0.5001 * digit[k]);
    }
    // the equation itself, by differences
    const double d = 1e-6, before = spring(t - d), after = spring(t + d);
    const double speed = (after - before) / (2 * d), force = (after - 2 * x + before) / (d * d);
    assert_near(force + gamma * speed + w2 * x, 0, 1e-4 * w2 * 0.01);
}

static void exact_cube_is_where_computed(void** state) {
    (void)state;
    const TruthCube cube = truth_cube_default();
    const double w2 = 140000, push = 100 * sqrt(3) / 24 / cube.mass;
    assert_near(truth_cube_rest(&cube), 1.78359993874652, last(14));
    assert_near(truth_cube_growth(&cube, 0), 0, 1e-17);
    assert_near(truth_cube_growth(&cube, 0.005), 0.0647575094287, last(13));
    assert_near(truth_cube_growth(&cube, 0.02), 0.035105218866, last(12));
    assert_near(method_euler.limit(w2, 20), 5.2042764e-3, last(10));
    const double want[] = {1.8610e-3, 9.2498e-4, 4.6116e-4}, digit[] = {1e-7, 1e-8, 1e-8};
    for (int k = 0; k < 3; k++) {
        double v = 0;
        const double u = euler(w2, 20, push, 0, &v, 2e-4 / (1 << k), 25 << k);
        assert_near(fabs(u - truth_cube_growth(&cube, 0.005)), want[k], 0.5001 * digit[k]);
    }
    double v = 0;
    assert_near(sqrt(3) + euler(w2, 20, push, 0, &v, 1e-4, 2000), 1.77769353863185, 1e-13);
}

// --- sheets, strings, balls, discs -------------------------------------------------------------

/// l - 1 of a sphere of Hooke's springs under `area` inflation, pressure 100 amount/A:
/// 100 amount/(4 pi R0^2 l^2) = 2 B (l-1)/(R0 l^2), so 100 amount/(8 pi R0 B), exactly [1].
static double area_growth(double amount, double radius, double biaxial) {
    return 100 * amount / (8 * PI * radius * biaxial);
}

static void springs_make_a_sheet_of_known_moduli(void** state) {
    (void)state;
    const TruthSheet paper = truth_sheet(50, 10, 10);
    assert_near(paper.along, 99, 1e-12);
    assert_near(paper.diagonal, 33.85, last(2));
    assert_near(area_growth(1, 1, paper.biaxial), 0.036172, last(6));
    // E h = 1: isotropic Hooke sheet of nu = 1/3, B = 1.5; rubber's B = 2. Flexion 4 kf for part of
    // ks.
    const TruthSheet isotropic = truth_sheet(0.35, 3.0 / 8, 0.1);
    assert_close(isotropic.along, 1.0, 1e-14);
    assert_close(isotropic.diagonal, 1.0, 1e-14);
    assert_close(isotropic.biaxial, 1.5, 1e-14);
    assert_close(isotropic.c12 / isotropic.c11, 1.0 / 3, 1e-14);
    assert_close(truth_sheet(0.6, 0.5, 0.1).biaxial, 2.0, 1e-14);
}

/// The growth is exact: at it, `area` pressure is what Hooke's springs hold.
static void area_inflation_balances_hooke_springs(void** state) {
    (void)state;
    TruthBalloon b = truth_balloon_default();
    b.law = truth_law_find("hooke");
    const double sheet = b.springs * b.modulus * b.thickness;
    const double l = 1 + area_growth(300, b.radius, sheet);
    const double area = 4 * PI * b.radius * b.radius * l * l;
    assert_close(truth_pressure(&b, l), 100 * 300 / area, 1e-12);
}

static void string_holds_what_helium_lifts(void** state) {
    (void)state;
    // 26 particles at 25 m/s^2 up, 9.8 down
    assert_close(truth_tether(26, 1e-3, 25, 9.8), 0.3952, 1e-14);
}

/// Meridional tension of sewn discs at distance x from the axis, p r^2/(2 x) [N/m].
static double tension(const TruthMylar* mylar, double pressure, double x) {
    return pressure * mylar->radius * mylar->radius / (2 * x);
}

static void sewn_discs_have_the_mylar_shape(void** state) {
    (void)state;
    const TruthMylar one = truth_mylar(1), two = truth_mylar(2);
    assert_near(one.radius, 0.7627597635, last(10));
    assert_near(one.thickness, 0.9138931621, last(10));
    assert_near(one.volume, 1.2185242161, last(10));
    assert_close(two.volume, 8 * one.volume, 1e-14);
    // Legendre's relation of the lemniscate's two integrals: their product is pi/4
    assert_close(1 / one.radius * one.thickness / (2 * one.radius), PI / 4, 1e-14);
    // virtual work: the tension's total over the meridians, 2 discs, times their growth is p dV
    double work = 0;
    enum { PARTS = 1000 };
    for (int i = 0; i < PARTS; i++) { // arc ds = r^2/sqrt(r^4 - x^4) dx, x = r sin(q)
        const double x = one.radius * sin((i + 0.5) * PI / (2 * PARTS)), s = x / one.radius;
        const double arc = one.radius / sqrt(1 + s * s) * PI / (2 * PARTS);
        work += 2 * tension(&one, 7, x) * 2 * PI * x * arc;
    }
    assert_close(work, 7 * 3 * one.volume, 1e-10);
}

// --- the largest stable step -------------------------------------------------------------------

/// Spectral radius of a 2 x 2 matrix, the limit of |A^n|^(1/n) at n = 2^50: squared 50 times, each
/// time scaled to largest entry 1.
static double spectral_radius(double a, double b, double c, double d) {
    double log_size = 0, share = 1;
    for (int k = 0; k < 50; k++) {
        const double size = fmax(fmax(fabs(a), fabs(b)), fmax(fabs(c), fabs(d)));
        log_size += share * log(size);
        share /= 2;
        a /= size, b /= size, c /= size, d /= size;
        const double aa = a * a + b * c, bb = a * b + b * d, cc = c * a + d * c, dd = c * b + d * d;
        a = aa, b = bb, c = cc, d = dd;
    }
    return exp(log_size);
}

/// The method's step on (x, v) of one mode; semi-implicit Euler moves x by the new speed.
static double growth(bool forward, double w2, double gamma, double h) {
    const double c = -h * w2, d = 1 - h * gamma;
    return forward ? spectral_radius(1, h, c, d) : spectral_radius(1 + h * c, h * d, c, d);
}

/// The step at which the fastest mode or rigid motion begins to grow, by bisection.
static double measured_limit(bool forward, double w2, double gamma) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; i++) {
        const double h = (low + high) / 2;
        const double worst = fmax(growth(forward, w2, gamma, h), growth(forward, 0, gamma, h));
        if (worst > 1 + 1e-11) // the radius itself is known to some 1e-14
            high = h;
        else
            low = h;
    }
    return low;
}

static void limits_are_those_computed_for_the_cube_sphere(void** state) {
    (void)state;
    const double w2 = 221899.946;
    const struct {
        double drag, euler, forward, digit;
    } row[] = {
        {0, 4.24572e-3, 0, 1e-8},
        {0.05, 4.026369e-3, 2.25327e-4, 1e-9},
        {0.2, 3.439027e-3, 9.01307e-4, 1e-9},
        {1, 1.684991e-3, 2.0e-3, 1e-9},
        {2, 9.49940e-4, 1.0e-3, 1e-9},
    };
    for (int i = 0; i < 5; i++) {
        const double gamma = row[i].drag / 1e-3;
        assert_near(method_euler.limit(w2, gamma), row[i].euler, 0.5001 * row[i].digit);
        assert_near(method_forward.limit(w2, gamma), row[i].forward, 0.5001e-9);
    }
    assert_close(method_euler.limit(0, 10), 0.2, 1e-15);
    assert_true(isinf(method_euler.limit(0, 0)));
}

/// Forward Euler's radius grows by gamma/2 per h at its limit gamma/w2, so 1e-11 of the radius is
/// 2e-11 w2/gamma^2 of h: 8e-7 in the worst of these.
static void limits_are_where_the_steps_begin_to_grow(void** state) {
    (void)state;
    const double w2[] = {1e4, 221899.946, 1e6}, gamma[] = {5, 50, 1000, 3000};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            assert_close(measured_limit(false, w2[i], gamma[j]),
                         method_euler.limit(w2[i], gamma[j]), 1e-6);
            assert_close(measured_limit(true, w2[i], gamma[j]),
                         method_forward.limit(w2[i], gamma[j]), 1e-6);
        }
        // undamped, forward Euler grows at any step: radius sqrt(1 + h^2 w2)
        assert_less(1, growth(true, w2[i], 0, 1e-5));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(damped_spring_is_where_computed),
        cmocka_unit_test(exact_cube_is_where_computed),
        cmocka_unit_test(springs_make_a_sheet_of_known_moduli),
        cmocka_unit_test(area_inflation_balances_hooke_springs),
        cmocka_unit_test(string_holds_what_helium_lifts),
        cmocka_unit_test(sewn_discs_have_the_mylar_shape),
        cmocka_unit_test(limits_are_those_computed_for_the_cube_sphere),
        cmocka_unit_test(limits_are_where_the_steps_begin_to_grow),
    };
    return cmocka_run_group_tests_name("truth_particle", tests, NULL, NULL);
}
