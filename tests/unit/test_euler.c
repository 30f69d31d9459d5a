/// Semi-implicit Euler: closed forms, order, invariants.
#include "bodies.h"
#include "force/damping.h"
#include "force/helium.h"
#include "force/force.h"
#include "mesh/measure.h"
#include "solve/method.h"

static void step(Body* body, double h, int count) {
    steps_of(&method_euler, body, &(Solver){0}, h, count);
}

/// x_n = -g h^2 n (n + 1) / 2 exactly.
static void free_fall_is_exact(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    mesh_of("cube", &mesh);
    body_of(&mesh, &body);
    body.gravity = 9.81;
    const double h = 1.0 / 128, first = (double)body.x[0][1];
    const int n = 128;
    step(&body, h, n);
    // float: the sum of 128 roundings of positions up to 6
    assert_near((double)body.x[0][1] - first, -9.81 * h * h * n * (n + 1) / 2,
                TOLERANCE(3e-5, 1e-13));
    assert_close((double)body.v[0][1], -9.81 * h * n, TOLERANCE(1e-6, 1e-14));
    body_free(&body);
    mesh_free(&mesh);
}

/// v_n = v_t (1 - (1 - c h/m)^n), v_t = m (a - g)/c, whatever the number of particles.
static void helium_rises_to_its_terminal_speed(void** state) {
    (void)state;
    const char* names[] = {"cube", "cube-sphere:6"};
    for (int k = 0; k < 2; k++) {
        Mesh mesh;
        Body body;
        mesh_of(names[k], &mesh);
        body_of(&mesh, &body);
        body.gravity = 9.8;
        body.force_parameter[FORCE_HELIUM][HELIUM_BASE] = 20;
        body.force_parameter[FORCE_HELIUM][HELIUM_PER_INFLATION] = 5;
        body_inflate(&body, &(Inflation){.law = INFLATE_AREA, .amount = 2});
        body.inflation.law = INFLATE_NONE; // an amount without pressure
        body.force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.2;
        const double h = 1e-3, terminal = paper_mass * (30 - 9.8) / 0.2;
        for (int n = 1; n <= 30; n++) {
            step(&body, h, 1);
            const double want = terminal * (1 - pow(1 - 0.2 * h / paper_mass, n));
            assert_close((double)body.v[0][1], want, TOLERANCE(1e-5, 1e-13));
        }
        body_free(&body);
        mesh_free(&mesh);
    }
}

static double damped_spring(double h) {
    Body body;
    chain_of(&body, (double[]){0, 1}, 2, 1e-3, 50);
    body.inverse_mass[0] = 0;
    body.force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.02;
    body.x[1][0] += (real)0.01;
    step(&body, h, (int)lround(0.05 / h));
    const double u = (double)body.x[1][0] - 1;
    body_free(&body);
    return u;
}

/// truth: x(0.05) = 7.80094746935e-4 and the errors of this method.
static void damped_spring_meets_its_errors(void** state) {
    (void)state;
    const double error[] = {1.0122e-4, 5.0279e-5, 2.5056e-5};
    for (int k = 0; k < 3; k++) {
        const double got = fabs(damped_spring(1e-4 / (1 << k)) - 7.80094746935e-4);
        // the table's last digit; float: 500 and more roundings of a position of 1, 6e-8 each
        assert_near(got, error[k], TOLERANCE(2e-6, 5e-9));
    }
}

/// An undamped spring keeps v^2/2 + w^2 u^2/2 - h w^2 u v/2, and oscillates at (2/h) asin(w h/2).
static void undamped_spring_keeps_its_invariant(void** state) {
    (void)state;
    Body body;
    chain_of(&body, (double[]){0, 1}, 2, 1e-3, 50);
    body.inverse_mass[0] = 0;
    const double w2 = 50 / 1e-3, h = 2e-3, amplitude = 0.01;
    body.x[1][0] += (real)amplitude;
    const double want = w2 * amplitude * amplitude / 2;
    int turns = 0;
    double before = amplitude, first = 0, last = 0;
    for (int n = 1; n <= 20000; n++) {
        step(&body, h, 1);
        const double u = (double)body.x[1][0] - 1, v = (double)body.v[1][0];
        if (n <= 1000)
            assert_close(v * v / 2 + w2 * u * u / 2 - h * w2 * u * v / 2, want,
                         TOLERANCE(3e-3, 1e-10));
        if (before < 0 && u >= 0) { // through zero upward, at a time between two steps
            last = h * (n - u / (u - before));
            first = turns++ == 0 ? last : first;
        }
        before = u;
    }
    const double frequency = 2 * PI * (turns - 1) / (last - first);
    assert_close(frequency, 2 / h * asin(sqrt(w2) * h / 2), TOLERANCE(1e-4, 2e-5));
    body_free(&body);
}

/// truth: the exact cube, side 2, 50/10/10, 1 g, drag 0.02, area inflation 1: one degree of
/// freedom.
static void exact_cube_of(Mesh* mesh, Body* body) {
    mesh_of("cube", mesh);
    body_of(mesh, body);
    body_add_springs(body, paper_springs, LAW_HOOKE);
    body_inflate(body, &(Inflation){.law = INFLATE_AREA, .amount = 1});
    body->force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.02;
}

/// Distance from center to corner after the steps.
static double exact_cube(double h, int steps) {
    Mesh mesh;
    Body body;
    exact_cube_of(&mesh, &body);
    step(&body, h, steps);
    const double r = dlength(to_double4(body.x[0]));
    for (int i = 1; i < body.count; i++) // it remains a cube
        assert_close(dlength(to_double4(body.x[i])), r, TOLERANCE(1e-5, 1e-13));
    body_free(&body);
    mesh_free(&mesh);
    return r;
}

static void exact_cube_follows_its_closed_form(void** state) {
    (void)state;
    // float: 2,000 steps, each rounding a position of 1 to 6e-8, against a restoring force
    assert_near(exact_cube(1e-4, 2000), 1.77769353863185, TOLERANCE(2e-5, 1e-12));
    assert_near(exact_cube(1e-4, 30000), 1.78359993874652, TOLERANCE(2e-5, 1e-9));
}

static void exact_cube_meets_its_errors(void** state) {
    (void)state;
    const double h[] = {2e-4, 1e-4, 5e-5}, error[] = {1.8610e-3, 9.2498e-4, 4.6116e-4};
    for (int k = 0; k < 3; k++) {
        const double u = exact_cube(h[k], (int)lround(0.005 / h[k])) - sqrt(3);
        assert_near(fabs(u - 0.0647575094287), error[k], TOLERANCE(2e-5, 6e-8));
    }
}

/// Order 1 at a time other than the table's, by Richardson's ratio.
static void error_halves_with_the_step(void** state) {
    (void)state;
    const double want = sqrt(3) + 0.035105218866;
    double before = exact_cube(4e-4, 50) - want;
    for (int k = 1; k < 4; k++) {
        const double now = exact_cube(4e-4 / (1 << k), 50 << k) - want;
        assert_near(log2(before / now), 1, TOLERANCE(0.2, 0.1));
        before = now;
    }
}

/// Its only mode has w^2 = 140000: its amplitude grows above the limit and is bounded below it.
static void exact_cube_fails_where_theory_says(void** state) {
    (void)state;
    const double limit = 5.2042764e-3;
    const double far = 2 * sqrt(3);
    assert_less(fabs(exact_cube(0.98 * limit, 3000) - 1.7836), 0.01);
    Mesh mesh;
    Body body;
    exact_cube_of(&mesh, &body);
    double r = 0;
    for (int n = 0; n < 3000 && r < far; n++) {
        step(&body, 1.02 * limit, 1);
        r = fmax(r, dlength(to_double4(body.x[0])));
    }
    assert_true(r >= far);
    body_free(&body);
    mesh_free(&mesh);
}

/// A free, shaken, spinning closed skin under springs and pressure keeps both momenta.
static void free_balloon_keeps_its_momenta(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    mesh_of("torus:16x8", &mesh);
    body_of(&mesh, &body);
    body_add_springs(&body, paper_springs, LAW_HOOKE);
    body_add_torsion(&body, 0.01);
    body_inflate(&body, &(Inflation){.law = INFLATE_AREA, .amount = 5});
    shake(&body, 0.02);
    for (int i = 0; i < body.count; i++)
        body.v[i] = cross((real4){(real)0.3, 1, (real)-0.2, 0}, body.x[i]) +
                    (real4){(real)0.4, 0, (real)0.1, 0};

    double4 p[2] = {{0}}, l[2] = {{0}};
    double sum = 0;
    for (int when = 0; when < 2; when++) {
        sum = 0;
        for (int i = 0; i < body.count; i++) {
            const double4 v = to_double4(body.v[i]), x = to_double4(body.x[i]);
            p[when] += paper_mass * v;
            l[when] += paper_mass * dcross(x, v);
            sum += paper_mass * dlength(v);
        }
        if (when == 0)
            step(&body, 5e-4, 2000);
    }
    // rounding of 2,000 steps, as a random walk in a sum of 128 particles
    assert_near(dlength(p[1] - p[0]), 0, TOLERANCE(1e-4, 1e-12) * sum);
    assert_near(dlength(l[1] - l[0]), 0, TOLERANCE(1e-4, 1e-12) * sum);
    body_free(&body);
    mesh_free(&mesh);
}

/// truth: cube-spheres of 50/10/10 under area inflation 1 grow by this much in (V/V0)^(1/3).
static void sphere_grows_as_its_sheet_allows(void** state) {
    (void)state;
    const int n[] = {4, 8};
    const double want[] = {0.03733, 0.03733};
    for (int k = 0; k < 2; k++) {
        Mesh mesh;
        Body body;
        char name[32];
        snprintf(name, sizeof name, "cube-sphere:%d", n[k]);
        mesh_of(name, &mesh);
        body_of(&mesh, &body);
        body_add_springs(&body, paper_springs, LAW_HOOKE);
        body_inflate(&body, &(Inflation){.law = INFLATE_AREA, .amount = 1});
        body.force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.05;
        const double first = body.inflation.first_volume;
        step(&body, 1e-3, 6000);
        const double growth = cbrt(measure_volume(&mesh, body.x) / first) - 1;
        assert_near(growth, want[k], 1e-5);
        body_free(&body);
        mesh_free(&mesh);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_fall_is_exact),
        cmocka_unit_test(helium_rises_to_its_terminal_speed),
        cmocka_unit_test(damped_spring_meets_its_errors),
        cmocka_unit_test(undamped_spring_keeps_its_invariant),
        cmocka_unit_test(exact_cube_follows_its_closed_form),
        cmocka_unit_test(exact_cube_meets_its_errors),
        cmocka_unit_test(error_halves_with_the_step),
        cmocka_unit_test(exact_cube_fails_where_theory_says),
        cmocka_unit_test(free_balloon_keeps_its_momenta),
        cmocka_unit_test(sphere_grows_as_its_sheet_allows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
