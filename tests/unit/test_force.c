/// Every row of the force table: force against energy, net force and torque, and single laws.
#include "bodies.h"
#include "force/force.h"
#include "force/inflation.h"
#include "force/material.h"
#include "force/strings.h"
#include "force/tangent.h"
#include "mesh/measure.h"

/// A closed skin, shaken, with everything that the table knows acting on it.
static void everything(const Mesh* mesh, Body* body, SpringLaw spring_law, InflationLaw law,
                       const Material* material) {
    body_of(mesh, body);
    body->gravity = 9.8;
    rubber_on(body, material, 0.3, 300, 1);
    for (int e = 0; e < body->membrane.count; e++)
        body->membrane.thickness[e] *= (real)0.9;
    body_add_springs(body, paper_springs, spring_law);
    body_add_torsion(body, 0.01);
    body_inflate(body, &(Inflation){.law = law,
                                    .amount = law == INFLATE_PRESSURE ? 20 : 1.5,
                                    .unit = 10,
                                    .ambient = 10,
                                    .temperature = 1,
                                    .adiabatic = material->incompressible,
                                    .weighs = law == INFLATE_GAS,
                                    .filling = filling_table[1]});
    body->helium = (Helium){20, 5};
    body->damping = (Damping){0.02, 1};
    body_tie(body, 3, (double[]){0.1, -3, 0.2}, 50, 0.9);
    body_tie(body, 5, (double[]){0, 4, 0}, 50, 1.2); // slack
    shake(body, 0.05);
    for (int i = 0; i < body->count; i++)
        body->v[i] = (real4){(real)0.3, (real)-0.1, (real)(0.01 * i), 0};
}

/// `area` inflation pushes with a pressure that its energy holds frozen at this state.
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
    double most = 0;
    for (int i = 0; i < body->count; i++)
        most = fmax(most, (double)length(body->f[i]));

    for (int i = 0; i < body->count; i += 7)
        for (int k = 0; k < 3; k++) {
            const real x = body->x[i][k];
            body->x[i][k] = x + h;
            const double high = energy_at(force, body, p), above = (double)body->x[i][k];
            body->x[i][k] = x - h;
            const double low = energy_at(force, body, p), below = (double)body->x[i][k];
            body->x[i][k] = x;
            const double want = -(high - low) / (above - below);
            // float: the force is of float, and a spring has a kink where it begins to pull
            near_at((double)body->f[i][k], want, TOLERANCE(4e-3, 1e-6) * most, force->name,
                    __FILE__, __LINE__);
        }
}

static void force_is_the_gradient_of_its_energy(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:4", &mesh);
    for (int n = 0; n < SPRING_LAWS * material_count; n++)
        for (int law = INFLATE_AREA; law < INFLATION_LAWS; law++) {
            Body body;
            everything(&mesh, &body, (SpringLaw)(n % SPRING_LAWS), (InflationLaw)law,
                       material_table[n / SPRING_LAWS]);
            for (int k = 0; k < force_count; k++) {
                assert_true(force_table[k]->present(&body) ==
                            (force_table[k] != &force_lift || law == INFLATE_GAS));
                if (force_table[k]->energy && force_table[k]->present(&body))
                    check_gradient(force_table[k], &body);
            }
            body_free(&body);
        }
    mesh_free(&mesh);
}

/// `area` inflation at its frozen pressure, as its product has it.
static void force_at(const Force* force, Body* body, double frozen) {
    memset(body->f, 0, (size_t)body->count * sizeof *body->f);
    if (force == &force_inflation && body->inflation.law == INFLATE_AREA) {
        measure_volume_gradient(body->mesh, body->x, body->f);
        for (int i = 0; i < body->count; i++)
            body->f[i] *= (real)frozen;
        return;
    }
    force_add(force, body);
}

/// out = K d of row k of the table alone.
static void times_force(Tangent* tangent, Body* body, int k, bool project, const real4* d,
                        real4* out) {
    const Force* force = force_table[k];
    block_matrix_clear(&tangent->matrix);
    if (force->stiffen)
        force->stiffen(body, project);
    if (force->assemble)
        force->assemble(body, 1, project, tangent->slot[k], &tangent->matrix);
    block_matrix_multiply(&tangent->matrix, d, out);
    if (force->product)
        force->product(body, 1, d, out);
}

/// K d against -(f(x + h d) - f(x - h d)) / 2h.
static void check_product(Tangent* tangent, int row, Body* body) {
    const Force* force = force_table[row];
    const int n = body->count;
    const double frozen = inflation_pressure(body);
    real4 *rest = new_array(real4, n), *d = new_array(real4, n), *out = new_array(real4, n),
          *high = new_array(real4, n);
    memcpy(rest, body->x, (size_t)n * sizeof *rest);
    Random random = {99};
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            d[i][k] = (real)(2 * random_next(&random) - 1);

    times_force(tangent, body, row, false, d, out);
    const real h = (real)1e-6; // truncation h^2, rounding 1e-16 / h
    for (int i = 0; i < n; i++)
        body->x[i] = rest[i] + h * d[i];
    force_at(force, body, frozen);
    memcpy(high, body->f, (size_t)n * sizeof *high);
    for (int i = 0; i < n; i++)
        body->x[i] = rest[i] - h * d[i];
    force_at(force, body, frozen);

    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, (double)length(out[i]));
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            near_at((double)out[i][k], (double)((body->f[i][k] - high[i][k]) / (2 * h)),
                    1e-6 * most, force->name, __FILE__, __LINE__);
    memcpy(body->x, rest, (size_t)n * sizeof *rest);
    free(rest);
    free(d);
    free(out);
    free(high);
}

/// The whole tangent times a factor is the sum of its forces' parts.
static void check_whole(Tangent* tangent, Body* body) {
    const int n = body->count;
    const double factor = 3;
    real4 *d = new_array(real4, n), *out = new_array(real4, n), *sum = new_array(real4, n);
    for (int i = 0; i < n; i++)
        d[i] = (real4){(real)(i % 5), (real)(i % 3), (real) - (i % 7), 0};
    for (int k = 0; k < force_count; k++) {
        if (!force_table[k]->present(body))
            continue;
        times_force(tangent, body, k, false, d, out);
        for (int i = 0; i < n; i++)
            sum[i] += (real)factor * out[i];
    }
    tangent_ready(tangent, body, factor, false);
    tangent_multiply(tangent, body, factor, d, out);
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, (double)length(sum[i]));
    for (int i = 0; i < n; i++)
        assert_near((double)length(out[i] - sum[i]), 0, 100 * REAL_EPSILON * most);
    free(d);
    free(out);
    free(sum);
}

static void product_is_the_derivative_of_the_force(void** state) {
    (void)state;
    if (sizeof(real) == sizeof(float))
        skip(); // differences of float forces are noise
    Mesh mesh;
    mesh_of("cube-sphere:4", &mesh);
    for (int n = 0; n < SPRING_LAWS * material_count; n++)
        for (int law = INFLATE_AREA; law < INFLATION_LAWS; law++) {
            Body body;
            everything(&mesh, &body, (SpringLaw)(n % SPRING_LAWS), (InflationLaw)law,
                       material_table[n / SPRING_LAWS]);
            Tangent tangent;
            tangent_open(&tangent, &body);
            for (int k = 0; k < force_count; k++)
                if (force_table[k]->present(&body) && force_table[k] != &force_damping)
                    check_product(&tangent, k, &body);
            check_whole(&tangent, &body);
            tangent_close(&tangent);
            body_free(&body);
        }
    mesh_free(&mesh);
}

/// A projected tangent is never negative, whatever the state: d . K d >= 0.
static void projected_tangent_is_positive(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("cube-sphere:4", &mesh);
    for (int m = 0; m < material_count; m++) {
        Body body;
        everything(&mesh, &body, LAW_RUBBER, INFLATE_AREA, material_table[m]);
        for (int i = 0; i < body.count; i++)
            body.x[i] *= (real)0.7; // pressed
        real4 *d = new_array(real4, body.count), *out = new_array(real4, body.count);
        Tangent tangent;
        tangent_open(&tangent, &body);
        Random random = {7};
        bool negative = false;
        for (int round = 0; round < 100; round++)
            for (int k = 0; k < force_count; k++)
                for (int project = 0; project < 2; project++) {
                    for (int i = 0; i < body.count; i++)
                        d[i] = round ? (real4){(real)(random_next(&random) - 0.5),
                                               (real)(random_next(&random) - 0.5),
                                               (real)(random_next(&random) - 0.5), 0}
                                     : (real)(1 - 2 * (i % 2)) * body.x[i];
                    if (!force_table[k]->present(&body))
                        continue;
                    times_force(&tangent, &body, k, project, d, out);
                    double sum = 0, size = 0;
                    for (int i = 0; i < body.count; i++) {
                        sum += (double)dot(d[i], out[i]);
                        size += (double)(length(d[i]) * length(out[i]));
                    }
                    if (project)
                        assert_true(sum >= -1e-6 * size);
                    else
                        negative = negative || sum < -1e-6 * size;
                }
        assert_true(negative); // or there was nothing to project
        tangent_close(&tangent);
        free(d);
        free(out);
        body_free(&body);
    }
    mesh_free(&mesh);
}

/// (rho V - m) g upward, and nothing to the sides.
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
                if (!force_table[k]->internal)
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

/// Longitudinal modes of a chain with fixed ends: w_j = 2 sqrt(k/m) sin(j pi / (2 (n + 1))).
static void chain_has_its_frequencies(void** state) {
    (void)state;
    enum { FREE = 9 };
    const double mass = 1e-3, stiffness = 50, pi = 3.14159265358979323846;
    double place[FREE + 2];
    for (int i = 0; i < FREE + 2; i++)
        place[i] = i;
    for (int j = 1; j <= FREE; j++) {
        Body body;
        chain_of(&body, place, FREE + 2, mass, stiffness);
        for (int i = 1; i <= FREE; i++)
            body.x[i][0] += (real)(0.01 * sin(i * j * pi / (FREE + 1)));
        force_sum(&body);
        const double w = 2 * sqrt(stiffness / mass) * sin(j * pi / (2 * (FREE + 1)));
        for (int i = 1; i <= FREE; i++) {
            const double u = 0.01 * sin(i * j * pi / (FREE + 1));
            // float: places up to 10 round to 5e-7, times a stiffness of 4 * 50
            assert_near((double)body.f[i][0], -mass * w * w * u, TOLERANCE(4e-4, 1e-12));
        }
        body_free(&body);
    }
}

static double pull_at(SpringLaw law, double stretch) {
    Body body;
    chain_of(&body, (double[]){0, 2}, 2, 1, 30);
    body.springs.law = law;
    body.x[1][0] = (real)(2 * stretch);
    force_sum(&body);
    const double pull = (double)body.f[0][0];
    assert_near((double)body.f[1][0], -pull, 0);
    body_free(&body);
    return pull;
}

static void spring_laws_are_what_they_say(void** state) {
    (void)state;
    const double k = 30, rest = 2, rounding = TOLERANCE(1e-5, 1e-13);
    for (double l = 0.3; l < 4; l += 0.1) {
        assert_near(pull_at(LAW_HOOKE, l), k * rest * (l - 1), 100 * rounding);
        const double rubber = l > 1 ? k * rest * (l - pow(l, -5)) / 6 : k * rest * (l - 1);
        assert_near(pull_at(LAW_RUBBER, l), rubber, 100 * rounding);
        assert_near(pull_at(LAW_TENSION, l), l > 1 ? k * rest * (l - 1) : 0, 100 * rounding);
    }
    // slope k at rest from both sides
    const double h = TOLERANCE(1e-3, 1e-6);
    assert_close((pull_at(LAW_RUBBER, 1 + h) - pull_at(LAW_RUBBER, 1 - h)) / (2 * h * rest), k,
                 10 * h + TOLERANCE(1e-3, 1e-8));
}

/// A square sheet of springs is C11 = ks + 4 kf + kd, C12 = C66 = kd: the energy per area of a
/// torus-free patch, from the springs that one interior particle owns.
static void sheet_has_the_moduli_of_its_springs(void** state) {
    (void)state;
    Mesh mesh;
    mesh_of("grid:12x12", &mesh);
    const double ks = 50, kd = 10, kf = 7, cell = 2.0 / 12;
    const struct {
        double xx, zz, xz, want;
    } strain[] = {
        {1, 0, 0, (ks + 4 * kf + kd) / 2},
        {1, 1, 0, ks + 4 * kf + kd + kd},
        {0, 0, 1, kd * 2}, // u_x = e z and u_z = e x: shear angle 2 e, energy C66 (2 e)^2 / 2
    };
    for (size_t s = 0; s < sizeof strain / sizeof *strain; s++) {
        Body body;
        body_of(&mesh, &body);
        body_add_springs(&body, (double[SPRING_KINDS]){ks, kd, kf}, LAW_HOOKE);
        const double e = TOLERANCE(1e-2, 1e-4);
        for (int i = 0; i < body.count; i++) {
            const double x = (double)body.x[i][0], z = (double)body.x[i][2];
            body.x[i][0] += (real)(e * (strain[s].xx * x + strain[s].xz * z));
            body.x[i][2] += (real)(e * (strain[s].zz * z + strain[s].xz * x));
        }
        // the particle nearest the middle owns half of each of its springs, and one cell of area
        int middle = 0;
        for (int i = 0; i < body.count; i++)
            if (dlength(mesh.point[i]) < dlength(mesh.point[middle]))
                middle = i;
        double sum = 0;
        for (int k = 0; k < body.springs.count; k++) {
            const int* end = body.springs.end[k];
            if (end[0] != middle && end[1] != middle)
                continue;
            const double4 d = to_double4(body.x[end[1]]) - to_double4(body.x[end[0]]);
            const double over = dlength(d) - (double)body.springs.rest[k];
            sum += 0.25 * (double)body.springs.stiffness[k] * over * over;
        }
        // the difference to the linear theory is of the order of the strain
        assert_close(sum / (cell * cell) / (e * e), strain[s].want, 2 * e + TOLERANCE(2e-3, 0));
        body_free(&body);
    }
    mesh_free(&mesh);
}

static void area_pressure_is_100_amount_over_area(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    mesh_of("cube", &mesh);
    body_of(&mesh, &body);
    body_inflate(&body, &(Inflation){.law = INFLATE_AREA, .amount = 1});
    assert_close(inflation_pressure(&body), 100.0 / 24, TOLERANCE(1e-6, 1e-15));
    force_sum(&body);
    // a quarter of three faces' area vectors of 4: (1, 1, 1), outward
    for (int i = 0; i < body.count; i++)
        for (int k = 0; k < 3; k++)
            assert_close((double)body.f[i][k], 100.0 / 24 * (double)body.x[i][k],
                         TOLERANCE(1e-6, 1e-14));
    body_free(&body);
    mesh_free(&mesh);
}

static void gas_at_its_first_amount_pushes_nothing(void** state) {
    (void)state;
    Mesh mesh;
    Body body;
    mesh_of("cube-sphere:4", &mesh);
    body_of(&mesh, &body);
    body_inflate(
        &body,
        &(Inflation){
            .law = INFLATE_GAS, .amount = 1, .unit = 101325, .ambient = 101325, .temperature = 1});
    assert_near(inflation_pressure(&body), 0, 1e-9);
    body.inflation.amount = 2;
    assert_close(inflation_pressure(&body), 101325.0, 1e-12);
    body_free(&body);
    mesh_free(&mesh);
}

static void string_pulls_only_past_its_free_length(void** state) {
    (void)state;
    Body body;
    chain_of(&body, (double[]){0, 1}, 2, 1, 0);
    body_tie(&body, 1, (double[]){4, 0, 0}, 50, 1.2); // free length 3.6
    force_sum(&body);
    assert_near((double)body.f[1][0], 0, 0);
    const double rounding = TOLERANCE(1e-4, 1e-12);
    for (double over = 0; over < 1; over += 0.125) {
        body.x[1][0] = (real)(4 - 3.6 - over);
        force_sum(&body);
        assert_near((double)body.f[1][0], 50 * over, rounding);
        assert_near(string_tension(&body, 0), 50 * over, rounding);
    }
    body_free(&body);
}

/// Energy of a bend against rest: k (2 sin(phi/2))^2 / 2.
static void torsion_holds_the_angle(void** state) {
    (void)state;
    Body body;
    chain_of(&body, (double[]){-1, 0, 1}, 3, 1, 0);
    body.torsion = (Torsion){
        .count = 1, .path = new_array(int[3], 1), .rest = new_array(real, 1), .stiffness = 2};
    memcpy(body.torsion.path[0], (int[]){0, 1, 2}, sizeof(int[3]));
    const double phi = 0.8;
    body.x[2] = (real4){(real)cos(phi), (real)sin(phi), 0, 0};
    const double bend = 2 * sin(phi / 2);
    assert_close(force_torsion.energy(&body), 0.5 * 2 * bend * bend, TOLERANCE(1e-6, 1e-14));
    force_sum(&body);
    // -dE/dphi = -k sin(phi), at a lever of 1
    const double along = (double)(body.f[2][1] * (real)cos(phi) - body.f[2][0] * (real)sin(phi));
    assert_close(along, -2 * sin(phi), TOLERANCE(1e-6, 1e-14));
    body_free(&body);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(force_is_the_gradient_of_its_energy),
        cmocka_unit_test(product_is_the_derivative_of_the_force),
        cmocka_unit_test(projected_tangent_is_positive),
        cmocka_unit_test(lift_is_the_weight_of_the_air_less_the_gas),
        cmocka_unit_test(internal_forces_push_nothing_as_a_whole),
        cmocka_unit_test(chain_has_its_frequencies),
        cmocka_unit_test(spring_laws_are_what_they_say),
        cmocka_unit_test(sheet_has_the_moduli_of_its_springs),
        cmocka_unit_test(area_pressure_is_100_amount_over_area),
        cmocka_unit_test(gas_at_its_first_amount_pushes_nothing),
        cmocka_unit_test(string_pulls_only_past_its_free_length),
        cmocka_unit_test(torsion_holds_the_angle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
