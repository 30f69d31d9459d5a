/// Area, volume and volume gradient of warped skins: derivatives, invariances, known values.
#include "meshes.h"

#include "mesh/measure.h"

static const char* const closed_shapes[] = {"cube:3",    "cube-sphere:6", "icosphere:2",
                                            "torus:9x7", "pillow:5",      "discs:3x8"};
enum { CLOSED_SHAPES = sizeof closed_shapes / sizeof *closed_shapes };

/// The shape with every point moved by up to 0.05, so that no quad is flat.
static real4* warped_state(const char* name, Mesh* mesh) {
    load(name, mesh);
    real4* x = rest_state(mesh);
    Random random = {2};
    for (int i = 0; i < mesh->point_count; i++)
        for (int k = 0; k < 3; k++)
            x[i][k] += (real)(0.1 * (random_next(&random) - 0.5));
    return x;
}

/// The volume is cubic in the state, so central differences err by h^2/6 of its third derivative,
/// which is zero in one coordinate alone: only rounding is left, of the volume over 2 h and, in the
/// float build, of the gradient itself.
static void gradient_is_the_derivative_of_volume(void** state) {
    (void)state;
    const real h = (real)0.0078125;
    for (int s = 0; s < CLOSED_SHAPES; s++) {
        Mesh mesh;
        real4* x = warped_state(closed_shapes[s], &mesh);
        real4* gradient = new_array(real4, mesh.point_count);
        measure_volume_gradient(&mesh, x, gradient);
        for (int i = 0; i < mesh.point_count; i++) {
            for (int k = 0; k < 3; k++) {
                const real here = x[i][k];
                x[i][k] = here + h;
                const double step_up = (double)x[i][k] - (double)here;
                const double above = measure_volume(&mesh, x);
                x[i][k] = here - h;
                const double step_down = (double)here - (double)x[i][k];
                const double below = measure_volume(&mesh, x);
                x[i][k] = here;
                assert_near(gradient[i][k], (above - below) / (step_up + step_down),
                            TOLERANCE(2e-6, 1e-12));
            }
            assert_true(gradient[i][3] == 0);
        }
        free(gradient);
        free(x);
        mesh_free(&mesh);
    }
}

static void gradient_at_a_point_is_that_of_the_whole(void** state) {
    (void)state;
    static const char* const shapes[] = {"cube:3", "icosphere:2", "torus:9x7", "grid:5x4"};
    for (size_t s = 0; s < sizeof shapes / sizeof *shapes; s++) {
        Mesh mesh;
        real4* x = warped_state(shapes[s], &mesh);
        real4* gradient = new_array(real4, mesh.point_count);
        measure_volume_gradient(&mesh, x, gradient);
        for (int i = 0; i < mesh.point_count; i++) {
            const double4 at = measure_volume_gradient_at(&mesh, x, i);
            for (int k = 0; k < 3; k++) // sums of a few terms of size up to 1
                assert_near(at[k], (double)gradient[i][k], TOLERANCE(1e-6, 1e-14));
        }
        free(gradient);
        free(x);
        mesh_free(&mesh);
    }
}

/// Moving or turning a closed skin as a whole changes no volume: so the gas exerts no net force and
/// no net torque. The sums run over some 200 terms of size up to 1, each rounded once or twice.
static void closed_skin_feels_no_net_force_or_torque(void** state) {
    (void)state;
    for (int s = 0; s < CLOSED_SHAPES; s++) {
        Mesh mesh;
        real4* x = warped_state(closed_shapes[s], &mesh);
        real4* gradient = new_array(real4, mesh.point_count);
        measure_volume_gradient(&mesh, x, gradient);
        double4 force = {0};
        double4 torque = {0};
        for (int i = 0; i < mesh.point_count; i++) {
            const double4 g = to_double4(gradient[i]);
            force += g;
            torque += dcross(to_double4(x[i]), g);
        }
        assert_near(dlength(force), 0, 20 * REAL_EPSILON);
        assert_near(dlength(torque), 0, 20 * REAL_EPSILON);
        free(gradient);
        free(x);
        mesh_free(&mesh);
    }
}

/// Volume is of degree three: x . dV/dx = 3 V.
static void volume_is_a_third_of_its_gradient_along_x(void** state) {
    (void)state;
    for (int s = 0; s < CLOSED_SHAPES; s++) {
        Mesh mesh;
        real4* x = warped_state(closed_shapes[s], &mesh);
        real4* gradient = new_array(real4, mesh.point_count);
        measure_volume_gradient(&mesh, x, gradient);
        double along = 0;
        for (int i = 0; i < mesh.point_count; i++)
            along += ddot(to_double4(x[i]), to_double4(gradient[i]));
        assert_close(along / 3, measure_volume(&mesh, x), 20 * REAL_EPSILON);
        free(gradient);
        free(x);
        mesh_free(&mesh);
    }
}

/// The same area by both functions; in float the gradient's is of area vectors rounded to float.
static void gradient_returns_the_area(void** state) {
    (void)state;
    for (int s = 0; s < CLOSED_SHAPES; s++) {
        Mesh mesh;
        real4* x = warped_state(closed_shapes[s], &mesh);
        real4* gradient = new_array(real4, mesh.point_count);
        const double area = measure_volume_gradient(&mesh, x, gradient);
        assert_close(area, measure_area(&mesh, x), TOLERANCE(1e-7, 1e-15));
        free(gradient);
        free(x);
        mesh_free(&mesh);
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

/// truth.md section 5, reading 3: a quarter of each flat quad's area vector at each of its corners.
/// A cube's corner has a quarter of three sides of area 4.
static void flat_quads_push_by_a_quarter_of_their_area(void** state) {
    (void)state;
    Mesh mesh;
    load("cube", &mesh);
    real4* x = rest_state(&mesh);
    real4 gradient[8];
    measure_volume_gradient(&mesh, x, gradient);
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < 3; k++)
            assert_near(gradient[i][k], x[i][k], 4 * REAL_EPSILON);
    free(x);
    mesh_free(&mesh);
}

/// An open sheet's gradient is a quarter (a third) of each face's area vector: their sum is the
/// sheet's, and it encloses nothing.
static void open_sheets_push_by_their_area_vectors(void** state) {
    (void)state;
    const char* const names[] = {"grid:5x4", "disc:3x7"};
    for (int s = 0; s < 2; s++) {
        Mesh mesh;
        const MeshReport report = load(names[s], &mesh);
        real4* x = rest_state(&mesh);
        real4* gradient = new_array(real4, mesh.point_count);
        measure_volume_gradient(&mesh, x, gradient);
        double4 sum = {0};
        for (int i = 0; i < mesh.point_count; i++)
            sum += to_double4(gradient[i]);
        assert_near(sum[1], report.area, 20 * REAL_EPSILON);
        assert_near(sum[0], 0, 20 * REAL_EPSILON);
        assert_near(sum[2], 0, 20 * REAL_EPSILON);
        assert_true(measure_volume(&mesh, x) == 0);
        free(gradient);
        free(x);
        mesh_free(&mesh);
    }
}

/// A skin far away has the volume that it has here: 2^20 is exact in float, the details are not
/// finer than its last place, and the local origin takes it off again.
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
