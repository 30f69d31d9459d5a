/// Laws of single forces on a few particles: springs, sheets, inflation, strings, torsion.
#include "bodies.h"
#include "force/force.h"
#include "force/inflation.h"
#include "force/strings.h"

/// Longitudinal modes of a chain with fixed ends: w_j = 2 sqrt(k/m) sin(j pi / (2 (n + 1))).
static void chain_has_its_frequencies(void** state) {
    (void)state;
    enum { FREE = 9 };
    const double mass = 1e-3, stiffness = 50;
    double position[FREE + 2];
    for (int i = 0; i < FREE + 2; i++)
        position[i] = i;
    for (int j = 1; j <= FREE; j++) {
        Body body;
        chain_of(&body, position, FREE + 2, mass, stiffness);
        for (int i = 1; i <= FREE; i++)
            body.x[i][0] += (real)(0.01 * sin(i * j * PI / (FREE + 1)));
        force_sum(&body);
        const double w = 2 * sqrt(stiffness / mass) * sin(j * PI / (2 * (FREE + 1)));
        for (int i = 1; i <= FREE; i++) {
            const double u = 0.01 * sin(i * j * PI / (FREE + 1));
            // float: positions up to 10 round to 5e-7, times a stiffness of 4 * 50
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

/// A square sheet of springs has C11 = ks + 4 kf + kd, C12 = C66 = kd: the energy per area far from
/// the rim, from half of each spring of an interior particle.
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
