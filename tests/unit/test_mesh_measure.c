/// Area, volume and volume gradient of warped skins: derivatives, invariances, known values.
#include "meshes.h"

#include "mesh/measure.h"

static const char* const closed_shapes[] = {"cube:3",    "cube-sphere:6", "icosphere:2",
                                            "torus:9x7", "pillow:5",      "discs:3x8"};
enum { CLOSED_SHAPES = sizeof closed_shapes / sizeof *closed_shapes };

/// A shape in a deformed state, and the result of measure_volume_gradient.
typedef struct Measured {
    Mesh mesh;
    MeshReport report;
    real4 *x, *gradient;
    double area;
} Measured;

/// Every point moved by up to half of `by`.
static Measured measured(const char* name, double by) {
    Measured m;
    m.report = load(name, &m.mesh);
    m.x = rest_state(&m.mesh);
    Random random = {2};
    for (int i = 0; i < m.mesh.point_count; i++)
        for (int k = 0; k < 3; k++)
            m.x[i][k] += (real)(by * (random_next(&random) - 0.5));
    m.gradient = new_array(real4, m.mesh.point_count);
    m.area = measure_volume_gradient(&m.mesh, m.x, m.gradient);
    return m;
}

static void measured_free(Measured* m) {
    free(m->gradient);
    free(m->x);
    mesh_free(&m->mesh);
}

static const double warp = 0.1; // so that no quad is flat

/// The volume is cubic in the state, so central differences err by h^2/6 of its third derivative,
/// which is zero in one coordinate alone: only rounding is left, of the volume over 2 h and, in the
/// float build, of the gradient itself.
static void gradient_is_the_derivative_of_volume(void** state) {
    (void)state;
    const real h = (real)0.0078125;
    for (int s = 0; s < CLOSED_SHAPES; s++) {
        Measured m = measured(closed_shapes[s], warp);
        for (int i = 0; i < m.mesh.point_count; i++) {
            for (int k = 0; k < 3; k++) {
                const real here = m.x[i][k];
                m.x[i][k] = here + h;
                const double step_up = (double)m.x[i][k] - (double)here;
                const double above = measure_volume(&m.mesh, m.x);
                m.x[i][k] = here - h;
                const double step_down = (double)here - (double)m.x[i][k];
                const double below = measure_volume(&m.mesh, m.x);
                m.x[i][k] = here;
                assert_near(m.gradient[i][k], (above - below) / (step_up + step_down),
                            TOLERANCE(2e-6, 1e-12));
            }
            assert_true(m.gradient[i][3] == 0);
        }
        measured_free(&m);
    }
}

static void gradient_at_a_point_is_that_of_the_whole(void** state) {
    (void)state;
    static const char* const shapes[] = {"cube:3", "icosphere:2", "torus:9x7", "grid:5x4"};
    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
        Measured m = measured(shapes[s], warp);
        for (int i = 0; i < m.mesh.point_count; i++) {
            const double4 at = measure_volume_gradient_at(&m.mesh, m.x, i);
            for (int k = 0; k < 3; k++) // sums of a few terms of size up to 1
                assert_near(at[k], (double)m.gradient[i][k], TOLERANCE(1e-6, 1e-14));
        }
        measured_free(&m);
    }
}

/// A rigid motion of a closed skin does not change its volume, so the gas exerts no net force and
/// no net torque. The sums run over some 200 terms of size up to 1, each rounded once or twice.
static void closed_skin_feels_no_net_force_or_torque(void** state) {
    (void)state;
    for (int s = 0; s < CLOSED_SHAPES; s++) {
        Measured m = measured(closed_shapes[s], warp);
        double4 force = {0};
        double4 torque = {0};
        for (int i = 0; i < m.mesh.point_count; i++) {
            const double4 g = to_double4(m.gradient[i]);
            force += g;
            torque += dcross(to_double4(m.x[i]), g);
        }
        assert_near(dlength(force), 0, 20 * REAL_EPSILON);
        assert_near(dlength(torque), 0, 20 * REAL_EPSILON);
        measured_free(&m);
    }
}

/// Volume is of degree three: x . dV/dx = 3 V.
static void volume_is_a_third_of_its_gradient_along_x(void** state) {
    (void)state;
    for (int s = 0; s < CLOSED_SHAPES; s++) {
        Measured m = measured(closed_shapes[s], warp);
        double along = 0;
        for (int i = 0; i < m.mesh.point_count; i++)
            along += ddot(to_double4(m.x[i]), to_double4(m.gradient[i]));
        assert_close(along / 3, measure_volume(&m.mesh, m.x), 20 * REAL_EPSILON);
        measured_free(&m);
    }
}

/// The same area by both functions; in float the gradient's is of area vectors rounded to float.
static void gradient_returns_the_area(void** state) {
    (void)state;
    for (int s = 0; s < CLOSED_SHAPES; s++) {
        Measured m = measured(closed_shapes[s], warp);
        assert_close(m.area, measure_area(&m.mesh, m.x), TOLERANCE(1e-7, 1e-15));
        measured_free(&m);
    }
}

static void cube_has_area_24_and_volume_8(void** state) {
    (void)state;
    Mesh mesh;
    load("cube:4", &mesh);
    real4* x = rest_state(&mesh);
    assert_close(measure_area(&mesh, x), 24.0, 1e-15);
    assert_close(measure_volume(&mesh, x), 8.0, 1e-15);
    free(x);
    mesh_free(&mesh);
}

/// The gradient on flat quads is a quarter of each quad's area vector at each of its corners.
/// A cube's corner has a quarter of three sides of area 4.
static void flat_quads_push_by_a_quarter_of_their_area(void** state) {
    (void)state;
    Measured m = measured("cube", 0);
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < 3; k++)
            assert_near(m.gradient[i][k], m.x[i][k], 4 * REAL_EPSILON);
    measured_free(&m);
}

/// An open sheet's gradient is a quarter (a third) of each face's area vector; the sum is the
/// sheet's area vector, and its volume is 0.
static void open_sheets_push_by_their_area_vectors(void** state) {
    (void)state;
    const char* const names[] = {"grid:5x4", "disc:3x7"};
    for (int s = 0; s < 2; s++) {
        Measured m = measured(names[s], 0);
        double4 sum = {0};
        for (int i = 0; i < m.mesh.point_count; i++)
            sum += to_double4(m.gradient[i]);
        assert_near(sum[1], m.report.area, 20 * REAL_EPSILON);
        assert_near(sum[0], 0, 20 * REAL_EPSILON);
        assert_near(sum[2], 0, 20 * REAL_EPSILON);
        assert_true(measure_volume(&m.mesh, m.x) == 0);
        measured_free(&m);
    }
}

/// The volume of a skin does not change far from the origin: 2^20 is exact in float, the details
/// are not finer than its last digit, and the local origin removes it.
static void distance_costs_no_digits(void** state) {
    (void)state;
    Mesh mesh;
    load("cube:4", &mesh);
    real4* x = rest_state(&mesh);
    for (int i = 0; i < mesh.point_count; i++)
        x[i] += (real4){1048576, -1048576, 1048576, 0};
    assert_close(measure_volume(&mesh, x), 8.0, 1e-15);
    assert_close(measure_area(&mesh, x), 24.0, 1e-15);
    free(x);
    mesh_free(&mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gradient_is_the_derivative_of_volume),
        cmocka_unit_test(gradient_at_a_point_is_that_of_the_whole),
        cmocka_unit_test(closed_skin_feels_no_net_force_or_torque),
        cmocka_unit_test(volume_is_a_third_of_its_gradient_along_x),
        cmocka_unit_test(gradient_returns_the_area),
        cmocka_unit_test(cube_has_area_24_and_volume_8),
        cmocka_unit_test(flat_quads_push_by_a_quarter_of_their_area),
        cmocka_unit_test(open_sheets_push_by_their_area_vectors),
        cmocka_unit_test(distance_costs_no_digits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
