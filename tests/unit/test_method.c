/// Laws for every method of the table: motion, order, momenta, workspace.
#include "bodies.h"
#include "force/damping.h"
#include "force/force.h"
#include "force/helium.h"
#include "mesh/measure.h"

/// A number of iterations with which each step is solved to the state's precision.
static const Solver thorough = {.iterations = 100, .tolerance = 1e-12, .linear_tolerance = 1e-3};

static bool takes(const Method* method, const Body* body) {
    return !method_refuses(method, body);
}

/// Order 1 in its simplest form: after a time t the error of every method is g h t / 2, of either
/// sign.
static void free_fall_is_off_by_half_a_step(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube", &mesh);
    const double h = 1.0 / 1024, t = 1.0 / 8;
    for (int m = 0; m < method_count; m++) {
        Body body;
        body_of(&mesh, &body);
        body.gravity = 9.81;
        if (method_limit(method_table[m], 1, 0) > 0) // `forward` would blow up from their rounding
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
    body.force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.02;
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
            // the next term is h w^2 / g of the first, 1/8 at max; float rounds 2,000 positions
            assert_near(before / now, 2, TOLERANCE(0.3, 0.15));
            before = now;
        }
    }
}

/// A chain that falls on a floor within the step: the velocities that a kick returns stop at it.
static void a_kick_ends_with_velocities_that_respect_contacts(void** state) {
    (void)state;
    const double h = 1e-2, height = 1e-4;
    const Solver usual = {
        .tolerance = 0}; // each method's defaults: this law concerns contacts, not the solve
    for (int m = 0; m < method_count; m++) {
        Body body;
        chain_of(&body, (double[]){0, 1}, 2, paper_mass, 1);
        System system;
        Contacts contacts;
        SolveStats stats;
        const Plane floor = {
            .point = {0, -height, 0, 0}, .normal = {0, 1, 0, 0}, .friction = (real)0.8};
        system_open(&system, 1);
        system.body[0] = &body;
        system.workspace[0] = method_table[m]->open ? method_table[m]->open(&body, &usual) : NULL;
        system.stats[0] = &stats;
        system.v_start[0] = new_array(real4, body.count);
        contacts_open(&contacts, CONTACT_IMPULSE, 0, &floor, 1, (SkinContacts){0}, system.body,
                      (const real4* const*)system.v_start, 1);
        body.v[0][1] = -1; // 100 times the height in this step
        double drift = h;
        assert_true(method_table[m]->kick(method_table[m], &system, &contacts, h, &drift));
        assert_near(drift, h, 0);
        assert_near(body.v[0][1], -height / h, TOLERANCE(1e-6, 1e-12));

        body.asleep = true; // and a sleeping body is not changed
        body.v[0][1] = -1;
        assert_true(method_table[m]->kick(method_table[m], &system, &contacts, h, &drift));
        assert_near(body.v[0][1], -1, 0);

        contacts_close(&contacts);
        free(system.v_start[0]);
        if (method_table[m]->close)
            method_table[m]->close(system.workspace[0]);
        system_close(&system);
        body_free(&body);
    }
}

/// Springs and pressure do not move the center of mass.
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
            steps_of(method_table[m], &body, &thorough, 5e-4, 40);
            double4 p = {0};
            double sum = 0;
            for (int i = 0; i < body.count; i++) {
                p += paper_mass * to_double4(body.v[i]);
                sum += paper_mass * (double)length(body.v[i]);
            }
            const double mass = paper_mass * body.count;
            // rounding of 40 steps; the solver's residual is 1e-12 of the forces a step
            assert_near(p[0], 0.4 * mass, TOLERANCE(1e-4, 1e-9) * sum);
            assert_near(p[1], 0, TOLERANCE(1e-4, 1e-9) * sum);
            assert_near(p[2], 0.1 * mass, TOLERANCE(1e-4, 1e-9) * sum);
            body_free(&body);
        }
    mesh_free(&mesh);
}

static const Inflation blown[INFLATION_LAWS] = {
    [INFLATE_AREA] = {.law = INFLATE_AREA, .amount = 2},
    [INFLATE_PRESSURE] = {.law = INFLATE_PRESSURE, .amount = 10},
    [INFLATE_GAS] =
        {.law = INFLATE_GAS, .amount = 1.8, .unit = 100, .ambient = 100, .temperature = 1},
};

static bool is_of_constraints(const Method* method) {
    return method->takes && method->implicit;
}

/// Largest distance of a particle from its position by `newton`, for a shaken skin on a taut
/// string in `steps` steps.
static double distance_to_newton(const Method* method, const Mesh* mesh, SpringLaw springs,
                                 InflationLaw law, double h, int steps) {
    Body body[2];
    for (int k = 0; k < 2; k++) {
        body_of(mesh, &body[k]);
        body[k].gravity = 9.8;
        body[k].force_parameter[FORCE_HELIUM][HELIUM_BASE] = 20;
        body[k].force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.05;
        body_add_springs(&body[k], paper_springs, springs);
        if (law != INFLATE_NONE)
            body_inflate(&body[k], &blown[law]);
        body_tie(&body[k], 0, (double[]){0.3, -3, 0.2}, 50, 0.9);
        shake(&body[k], 0.02);
        if (k == 1 && !takes(method, &body[k]))
            continue;
        steps_of(k ? method : &method_newton, &body[k], &thorough, h, steps);
    }
    const bool accepted = takes(method, &body[1]);
    double max = 0;
    for (int i = 0; i < mesh->point_count; i++)
        max = fmax(max, dlength(to_double4(body[1].x[i]) - to_double4(body[0].x[i])));
    body_free(&body[0]);
    body_free(&body[1]);
    return accepted ? max : NAN;
}

/// Every fully converged implicit method gives the step of backward Euler.
static void converged_constraints_are_backward_euler(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:4", &mesh);
    for (int m = 0; m < method_count; m++)
        for (int springs = 0; springs < SPRING_LAWS; springs++) {
            if (!is_of_constraints(method_table[m]))
                continue;
            const double off = distance_to_newton(method_table[m], &mesh, (SpringLaw)springs,
                                                  INFLATE_NONE, 2e-3, 5);
            // newton stops at 1e-12 of the forces (20 m/s^2 and more: h^2 of that); in float at the
            // rounding of positions of 1
            assert_near(isnan(off) ? 0 : off, 0, TOLERANCE(1e-5, 1e-11));
        }
    mesh_free(&mesh);
}

/// The pressure acts along the direction at the predicted positions, with an error of h^2; so has
/// the force, and the positions after a step have one of h^4.
static void pressure_of_constraints_is_near_backward_euler_s(void** state) {
    (void)state;
    if (sizeof(real) == sizeof(float))
        skip(); // that is below its rounding
    Mesh mesh;
    mesh_of("cube-sphere:4", &mesh);
    for (int m = 0; m < method_count; m++)
        for (int law = INFLATE_AREA; law < INFLATION_LAWS; law++) {
            if (!is_of_constraints(method_table[m]))
                continue;
            double off[2];
            for (int k = 0; k < 2; k++)
                off[k] = distance_to_newton(method_table[m], &mesh, LAW_HOOKE, (InflationLaw)law,
                                            2e-4 / (1 << k), 1);
            assert_near(off[0] / off[1], 16, 1.5);
        }
    mesh_free(&mesh);
}

/// Volume of a settled skin under pressure.
static double settled(const Method* method, const Mesh* mesh, SpringLaw springs, InflationLaw law,
                      double h, int iterations) {
    Body body;
    body_of(mesh, &body);
    body_add_springs(&body, paper_springs, springs);
    body_inflate(&body, &blown[law]);
    body.force_parameter[FORCE_DAMPING][DAMPING_COEFFICIENT] = 0.1;
    double volume = NAN;
    if (takes(method, &body)) {
        steps_of(method, &body, &(Solver){.iterations = iterations, .tolerance = 1e-12}, h,
                 (int)lround(0.5 / h));
        volume = measure_volume(mesh, body.x);
    }
    body_free(&body);
    return volume;
}

/// Rest is where the forces vanish: the same for every method and step.
static void methods_come_to_the_same_rest(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:3", &mesh);
    for (int springs = 0; springs < SPRING_LAWS; springs++)
        for (int law = INFLATE_AREA; law < INFLATION_LAWS; law++) {
            const double want =
                settled(&method_euler, &mesh, (SpringLaw)springs, (InflationLaw)law, 1e-3, 1);
            for (int m = 0; m < method_count; m++) {
                const Method* method = method_table[m];
                const double h = method->implicit ? 8e-3 : 2e-4;
                const double got =
                    settled(method, &mesh, (SpringLaw)springs, (InflationLaw)law, h, 60);
                // motion after 0.5 s: exp(-25) of 0.1; float: a residual of 1e-6 of the forces
                assert_close(isnan(got) ? want : got, want, TOLERANCE(3e-5, 1e-9));
            }
        }
    mesh_free(&mesh);
}

/// With too few iterations the skin is softer than its springs, by a share that falls with
/// the square of the step.
static void constraints_stopped_early_are_soft(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:4", &mesh);
    const double want = settled(&method_euler, &mesh, LAW_HOOKE, INFLATE_GAS, 1e-3, 1);
    const double off[] = {
        settled(&method_xpbd, &mesh, LAW_HOOKE, INFLATE_GAS, 3.2e-2, 1) / want - 1,
        settled(&method_xpbd, &mesh, LAW_HOOKE, INFLATE_GAS, 1e-3, 1) / want - 1,
        settled(&method_xpbd, &mesh, LAW_HOOKE, INFLATE_GAS, 5e-4, 1) / want - 1,
    };
    assert_less(0.1, off[0]);
    assert_near(off[1] / off[2], 4, 0.5);
    mesh_free(&mesh);
}

/// A method of constraints would step a stiff force explicitly and without a bound if it has no
/// constraint for it: so a new row is refused until the method lists it.
static void a_force_unknown_to_a_method_of_constraints_is_refused(void** state) {
    (void)state;
    for (int m = 0; m < method_count; m++) {
        const ForceUse* use = method_table[m]->takes; // NULL: any force
        assert_int_equal(use != NULL, is_of_constraints(method_table[m]));
        for (; use && use->force; use++) // an accepted stiff force needs a constraint or a limit
            if (use->force->assemble && use->force != &force_inflation)
                assert_non_null(use->replaced);
    }
}

/// Every force with every method: the body steps, or it is refused by a sentence that names the
/// force.
static void every_force_steps_or_is_refused_by_name(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:2", &mesh);
    for (int m = 0; m < method_count; m++)
        for (int rubber = 0; rubber < 2; rubber++) {
            Body body;
            body_of(&mesh, &body);
            if (rubber)
                rubber_on(&body, material_find("neo-hookean"), 1e-3, 1e6, 1000);
            else
                body_add_springs(&body, paper_springs, LAW_HOOKE);
            if (!rubber)
                body_add_torsion(&body, 1e-3);
            const char* why = method_refuses(method_table[m], &body);
            assert_int_equal(why != NULL, is_of_constraints(method_table[m]));
            if (why)
                assert_non_null(strstr(why, rubber ? "'membrane'" : "'torsion'"));
            else
                steps_of(method_table[m], &body, &thorough, 1e-6, 1);
            body_free(&body);
        }
    mesh_free(&mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_fall_is_off_by_half_a_step),
        cmocka_unit_test(damped_spring_s_error_halves_with_the_step),
        cmocka_unit_test(a_kick_ends_with_velocities_that_respect_contacts),
        cmocka_unit_test(a_force_unknown_to_a_method_of_constraints_is_refused),
        cmocka_unit_test(every_force_steps_or_is_refused_by_name),
        cmocka_unit_test(free_balloon_keeps_its_linear_momentum),
        cmocka_unit_test(converged_constraints_are_backward_euler),
        cmocka_unit_test(pressure_of_constraints_is_near_backward_euler_s),
        cmocka_unit_test(methods_come_to_the_same_rest),
        cmocka_unit_test(constraints_stopped_early_are_soft),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
