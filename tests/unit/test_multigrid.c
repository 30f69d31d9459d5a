/// The multigrid preconditioner of implicit steps on all its levels, for a skin so large that two
/// consecutive levels have rotating nodes.
#include "bodies.h"
#include "force/tangent.h"
#include "solve/multigrid/multigrid.h"

typedef struct Fixture {
    Mesh mesh;
    Body body;
    Tangent tangent;
    Multigrid levels;
} Fixture;

/// A shaken ball of rubber, its tangent made positive and its mass in a step of 1/60 s; some
/// particles are held.
static void open_fixture(Fixture* f) {
    mesh_of("cube-sphere:80", &f->mesh);
    body_make(&f->body, &f->mesh, &(Placement){.scale = 0.1}, 1);
    rubber_on(&f->body, &material_neo_hookean, 3e-4, 1e6, 1000);
    for (int i = 0; i < 5; i++)
        f->body.inverse_mass[i] = 0;
    shake(&f->body, 2e-4);
    tangent_open(&f->tangent, &f->body);
    tangent_update(&f->tangent, &f->body, 1.0 / 3600, true);
    for (int i = 0; i < f->body.count; i++)
        for (int c = 0; c < 3; c++)
            block_matrix_diagonal(&f->tangent.matrix, i)->column[c][c] += f->body.mass[i];
    multigrid_open(&f->levels, &f->tangent.matrix, f->body.inverse_mass);
    multigrid_update(&f->levels, f->body.x, true);
    assert_true(f->levels.count >= 4);
    assert_true(f->levels.level[2].transfer.rows == 2);
}

static void close_fixture(Fixture* f) {
    multigrid_close(&f->levels);
    tangent_close(&f->tangent);
    body_free(&f->body);
    mesh_free(&f->mesh);
}

static real4* random_vectors(int count, uint64_t seed) {
    Random random = {seed};
    real4* v = new_array(real4, count);
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            v[i][c] = (real)(2 * random_next(&random) - 1);
    return v;
}

/// a . b, and the sum of |a_i| |b_i|, which rounding errors are relative to.
static double product(const real4* a, const real4* b, int count, double* size) {
    double sum = 0;
    *size = 0;
    for (int i = 0; i < count; i++) {
        sum += ddot(to_double4(a[i]), to_double4(b[i]));
        *size += dlength(to_double4(a[i])) * dlength(to_double4(b[i]));
    }
    return sum;
}

static const double rounding = 50 * (double)REAL_EPSILON;

/// f . P c = P^T f . c
static void restriction_is_the_transpose_of_prolongation(void** state) {
    (void)state;
    Fixture f;
    open_fixture(&f);
    for (int l = 0; l + 1 < f.levels.count; l++) {
        const Transfer* transfer = &f.levels.level[l].transfer;
        const int rows = f.levels.level[l].matrix->count;
        const int coarse_rows = f.levels.level[l + 1].matrix->count;
        real4 *c = random_vectors(coarse_rows, 1), *push = random_vectors(rows, 2);
        real4 *motion = new_array(real4, rows), *back = new_array(real4, coarse_rows);
        transfer_prolong(transfer, c, motion);
        transfer_restrict(transfer, push, back);
        double size, other;
        const double want = product(push, motion, rows, &size);
        assert_near(product(back, c, coarse_rows, &other), want, rounding * size);
        free(c);
        free(push);
        free(motion);
        free(back);
    }
    close_fixture(&f);
}

/// c . (P^T A P) c = P c . A P c, but for the term added to the rotations' diagonal.
static void coarse_energy_is_that_of_the_prolonged_motion(void** state) {
    (void)state;
    Fixture f;
    open_fixture(&f);
    for (int l = 0; l + 1 < f.levels.count; l++) {
        const BlockMatrix *fine = f.levels.level[l].matrix, *coarse = f.levels.level[l + 1].matrix;
        const Transfer* transfer = &f.levels.level[l].transfer;
        real4 *c = random_vectors(coarse->count, 3), *out = new_array(real4, coarse->count);
        real4 *motion = new_array(real4, fine->count), *force = new_array(real4, fine->count);
        transfer_prolong(transfer, c, motion);
        block_matrix_multiply(fine, motion, force);
        block_matrix_multiply(coarse, c, out);
        double size, ignored, held = 0;
        const double want = product(motion, force, fine->count, &size);
        for (int row = 1; transfer->arm && row < coarse->count; row += 2) {
            const Block* own = block_matrix_diagonal(coarse, row);
            const real trace = own->column[0][0] + own->column[1][1] + own->column[2][2];
            held += 1e-3 / (1 + 3e-3) * (double)(trace * dot(c[row], c[row]));
        }
        assert_near(product(c, out, coarse->count, &ignored) - held, want, 10 * rounding * size);
        free(c);
        free(out);
        free(motion);
        free(force);
    }
    close_fixture(&f);
}

/// A rigid rotation of the coarser nodes about an axis rotates the finer ones about it, each as
/// seen from a position among its neighbors that does not depend on the axis.
static void rigid_rotation_prolongs_to_a_rotation(void** state) {
    (void)state;
    Fixture f;
    open_fixture(&f);
    const Level *level = &f.levels.level[1], *coarse = level + 1;
    real4 *c = new_array(real4, coarse->matrix->count), *motion[2];
    const real4 axis[2] = {{1, 0, 0, 0}, {0, 0, 1, 0}};
    for (int a = 0; a < 2; a++) {
        for (int g = 0; g < level->transfer.aggregates; g++) {
            c[2 * g] = cross(axis[a], coarse->position[g]);
            c[2 * g + 1] = axis[a];
        }
        motion[a] = new_array(real4, level->matrix->count);
        transfer_prolong(&level->transfer, c, motion[a]);
    }
    const double exact = rounding * 0.1; // of the ball's radius
    for (int i = 0; i < level->transfer.nodes; i++) {
        const real4 by_x = motion[0][i], by_z = motion[1][i]; // (0, -z, y) and (-y, x, 0)
        assert_near((double)by_x[0], 0, exact);
        assert_near((double)by_z[2], 0, exact);
        assert_near((double)by_x[2], -(double)by_z[0], exact);
        const real4 position = {by_z[1], by_x[2], -by_x[1], 0};
        double farthest = 0;
        for (int k = level->transfer.neighbor_from[i]; k < level->transfer.neighbor_from[i + 1];
             k++) {
            const real4 to = level->position[level->transfer.neighbor[k]] - level->position[i];
            farthest = fmax(farthest, (double)length(to));
        }
        assert_less((double)length(position - level->position[i]), farthest);
    }
    free(c);
    free(motion[0]);
    free(motion[1]);
    close_fixture(&f);
}

/// w D^-1 A has no eigenvalue of 2 or more on any smoothed level: else the cycle would not be
/// positive.
static void smoothing_keeps_the_cycle_positive(void** state) {
    (void)state;
    Fixture f;
    open_fixture(&f);
    for (int l = 0; l + 1 < f.levels.count; l++) {
        const Level* level = &f.levels.level[l];
        const int n = level->matrix->count;
        real4 *v = random_vectors(n, 7), *image = new_array(real4, n);
        double max = 0, size;
        for (int power = 0; power < 100; power++) {
            block_matrix_multiply(level->matrix, v, image);
            block_kernels()->smooth_first(&level->slices, image, v);
            max = sqrt(product(v, v, n, &size));
            for (int i = 0; i < n; i++)
                v[i] /= (real)max;
        }
        assert_less(max, 2);
        free(v);
        free(image);
    }
    close_fixture(&f);
}

/// The coarsest level's solution is exact.
static void coarsest_is_solved(void** state) {
    (void)state;
    Fixture f;
    open_fixture(&f);
    const BlockMatrix* matrix = f.levels.level[f.levels.count - 1].matrix;
    real4 *want = random_vectors(matrix->count, 4), *b = new_array(real4, matrix->count);
    real4 *x = new_array(real4, matrix->count), *back = new_array(real4, matrix->count);
    block_matrix_multiply(matrix, want, b);
    coarsest_solve(&f.levels.coarsest, matrix->count, b, x);
    block_matrix_multiply(matrix, x, back);
    double residual = 0, all = 0;
    for (int i = 0; i < matrix->count; i++) {
        residual += (double)dot(back[i] - b[i], back[i] - b[i]);
        all += (double)dot(b[i], b[i]);
    }
    assert_less(sqrt(residual / all), 10 * rounding);
    free(want);
    free(b);
    free(x);
    free(back);
    close_fixture(&f);
}

/// a . B b = b . B a, a . B a > 0: conjugate gradients rest on it.
static void cycle_is_symmetric_and_positive(void** state) {
    (void)state;
    Fixture f;
    open_fixture(&f);
    const int n = f.body.count;
    real4 *a = random_vectors(n, 5), *b = random_vectors(n, 6);
    real4 *of_a = new_array(real4, n), *of_b = new_array(real4, n);
    const double along = multigrid_apply(&f.levels, a, of_a);
    multigrid_apply(&f.levels, b, of_b);
    double size, ignored;
    const double other = product(a, of_a, n, &size);
    assert_near(along, other, rounding * size);
    assert_less(0, along);
    const double want = product(b, of_a, n, &size);
    assert_near(product(a, of_b, n, &ignored), want, 10 * rounding * size);
    free(a);
    free(b);
    free(of_a);
    free(of_b);
    close_fixture(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restriction_is_the_transpose_of_prolongation),
        cmocka_unit_test(coarse_energy_is_that_of_the_prolonged_motion),
        cmocka_unit_test(rigid_rotation_prolongs_to_a_rotation),
        cmocka_unit_test(smoothing_keeps_the_cycle_positive),
        cmocka_unit_test(coarsest_is_solved),
        cmocka_unit_test(cycle_is_symmetric_and_positive),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
