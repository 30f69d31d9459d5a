/// Every row of the force table: its tangent against differences of its force, and its projection.
#include "everything.h"
#include "force/tangent.h"

/// `area` inflation at the constant pressure that its tangent assumes.
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
    if (force->update_tangent)
        force->update_tangent(body, project);
    if (force->assemble)
        force->assemble(body, 1, project, tangent->block_at[k], &tangent->matrix);
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
    tangent_update(tangent, body, factor, false);
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

static void check_products(Body* body) {
    Tangent tangent;
    tangent_open(&tangent, body);
    for (int k = 0; k < force_count; k++)
        if (force_table[k]->present(body) && force_table[k] != &force_damping)
            check_product(&tangent, k, body);
    check_whole(&tangent, body);
    tangent_close(&tangent);
}

static void product_is_the_derivative_of_the_force(void** state) {
    (void)state;
    if (sizeof(real) == sizeof(float))
        skip(); // differences of float forces are noise
    each_everything(check_products);
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
            body.x[i] *= (real)0.7; // compressed
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
        assert_true(negative); // else projection was not tested
        tangent_close(&tangent);
        free(d);
        free(out);
        body_free(&body);
    }
    mesh_free(&mesh);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(product_is_the_derivative_of_the_force),
        cmocka_unit_test(projected_tangent_is_positive),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
