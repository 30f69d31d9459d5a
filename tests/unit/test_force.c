/// Every row of the force table: force against energy, net force and torque.
#include "everything.h"

/// `area` inflation: its energy has the pressure of this state as a constant.
static double energy_at(const Force* force, Body* body, double frozen) {
    if (force == &force_inflation && body->inflation.law == INFLATE_AREA)
        return -frozen * measure_volume(body->mesh, body->x);
    return force->energy(body);
}

static void check_gradient(const Force* force, Body* body) {
    const double p = inflation_pressure(body);
    // central differences: error h^2 from the third derivative, which is large where a torsion path
    // is nearly straight; rounding energy/h, of an energy that is of double in both builds
    const real h = (real)TOLERANCE(1e-4, 1e-6);
    memset(body->f, 0, (size_t)body->count * sizeof *body->f);
    force_add(force, body);
    double max = 0;
    for (int i = 0; i < body->count; i++)
        max = fmax(max, (double)length(body->f[i]));

    for (int i = 0; i < body->count; i += 7)
        for (int k = 0; k < 3; k++) {
            const real x = body->x[i][k];
            body->x[i][k] = x + h;
            const double high = energy_at(force, body, p), above = (double)body->x[i][k];
            body->x[i][k] = x - h;
            const double low = energy_at(force, body, p), below = (double)body->x[i][k];
            body->x[i][k] = x;
            const double want = -(high - low) / (above - below);
            // float: the force has rounding of float, and a spring's force has a kink at its free
            // length
            near_at((double)body->f[i][k], want, TOLERANCE(4e-3, 1e-6) * max, force->name, __FILE__,
                    __LINE__);
        }
}

static void check_gradients(Body* body) {
    for (int k = 0; k < force_count; k++) {
        assert_true(force_table[k]->present(body) ==
                    (force_table[k] != &force_lift || body->inflation.law == INFLATE_GAS));
        if (force_table[k]->energy && force_table[k]->present(body))
            check_gradient(force_table[k], body);
    }
}

static void force_is_the_gradient_of_its_energy(void** state) {
    (void)state;
    each_everything(check_gradients);
}

/// (rho V - m) g upward, no horizontal force.
static void lift_is_the_weight_of_the_air_less_the_gas(void** state) {
    (void)state;
    const char* names[] = {"cube-sphere:4", "icosphere:2", "torus:12x8"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        Mesh mesh;
        Body body;
        mesh_of(names[n], &mesh);
        everything(&mesh, &body, LAW_HOOKE, INFLATE_GAS, &material_neo_hookean);
        body.inflation.unit = standard_pressure;
        memset(body.f, 0, (size_t)body.count * sizeof *body.f);
        force_add(&force_lift, &body);
        double4 net = {0};
        for (int i = 0; i < body.count; i++)
            net += to_double4(body.f[i]);
        const double volume = measure_volume(&mesh, body.x);
        const double gas = 0.138 * 1.2041 * 1.5 * body.inflation.first_volume;
        const double want = 9.8 * (1.2041 * volume - gas);
        assert_near(net[1], want, TOLERANCE(1e-4, 1e-11) * volume * 12);
        assert_near(net[0], 0, TOLERANCE(1e-4, 1e-11) * volume * 12);
        assert_near(net[2], 0, TOLERANCE(1e-4, 1e-11) * volume * 12);
        body_free(&body);
        mesh_free(&mesh);
    }
}

static void internal_forces_push_nothing_as_a_whole(void** state) {
    (void)state;
    const char* names[] = {"cube-sphere:6", "torus:12x8", "pillow:6", "icosphere:2"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++)
        for (int law = INFLATE_AREA; law < INFLATION_LAWS; law++) {
            Mesh mesh;
            Body body;
            mesh_of(names[n], &mesh);
            everything(&mesh, &body, LAW_RUBBER, (InflationLaw)law, &material_mooney_rivlin);
            for (int k = 0; k < force_count; k++) {
                if (force_table[k]->external || !force_table[k]->present(&body))
                    continue;
                memset(body.f, 0, (size_t)body.count * sizeof *body.f);
                force_add(force_table[k], &body);
                double4 net = {0}, torque = {0};
                double sum = 0;
                for (int i = 0; i < body.count; i++) {
                    net += to_double4(body.f[i]);
                    torque += dcross(to_double4(body.x[i]), to_double4(body.f[i]));
                    sum += (double)length(body.f[i]);
                }
                assert_true(sum > 0);
                assert_near(dlength(net), 0, 4 * REAL_EPSILON * sum);
                assert_near(dlength(torque), 0, 8 * REAL_EPSILON * sum);
            }
            body_free(&body);
            mesh_free(&mesh);
        }
}

static void check_parameters(const Parameter* parameters, int count, int capacity) {
    assert_true(count <= capacity);
    for (int p = 0; p < count; p++) {
        assert_true(parameters[p].min <= parameters[p].default_value);
        assert_true(parameters[p].default_value <= parameters[p].max);
        for (int q = 0; q < p; q++)
            assert_string_not_equal(parameters[p].name, parameters[q].name);
    }
}

static void a_body_stores_every_parameter_and_its_default_is_in_range(void** state) {
    (void)state;
    for (int k = 0; k < force_count; k++)
        check_parameters(force_table[k]->parameters, force_table[k]->parameter_count,
                         FORCE_PARAMETERS_MAX);
    for (int m = 0; m < material_count; m++)
        check_parameters(material_table[m]->parameters, material_table[m]->parameter_count,
                         MATERIAL_PARAMETERS_MAX);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(force_is_the_gradient_of_its_energy),
        cmocka_unit_test(lift_is_the_weight_of_the_air_less_the_gas),
        cmocka_unit_test(a_body_stores_every_parameter_and_its_default_is_in_range),
        cmocka_unit_test(internal_forces_push_nothing_as_a_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
