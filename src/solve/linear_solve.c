#include "solve/linear_solve.h"

#include <stdlib.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/memory.h"
#include "force/damping.h"

enum {
    PRODUCTS_MAX = 2000, ///< of one solve
    LEVELS_AGE_MAX = 40  ///< tangents for which coarse levels are kept
};

/// Coarse levels are rebuilt when a solve takes more products than
/// products_growth * first_products + products_margin. [1]
static const double products_growth = 1.25;
static const int products_margin = 8;

/// Limit of |r|_(1/M) / |R|_(1/M) after a solve [1]. The preconditioner's norm alone would not do:
/// it approximates the energy norm sqrt(r . A^-1 r), in which residuals along A's stiff directions
/// count little beside those along its few soft ones.
static const double residual_share_max = 0.5;

void linear_solve_open(LinearSolve* linear, Body* body) {
    const int n = body->count;
    *linear = (LinearSolve){
        .residual = new_array(real4, n),
        .direction = new_array(real4, n),
        .image = new_array(real4, n),
        .preconditioned = new_array(real4, n),
    };
    tangent_open(&linear->tangent, body);
    multigrid_open(&linear->levels, &linear->tangent.matrix, body->inverse_mass);
}

void linear_solve_begin(LinearSolve* linear, const Body* body) {
    linear->has_held = false;
    for (int i = 0; i < body->count; i++)
        if (!(body->inverse_mass[i] > 0))
            linear->has_held = true;
}

/// With `project`, K's blocks are replaced by their positive parts.
static double update(LinearSolve* linear, Body* body, double h, bool project) {
    tangent_update(&linear->tangent, body, h * h, project);
    double noise = 0;
    for (int i = 0; i < body->count; i++) {
        Block* block = block_matrix_diagonal(&linear->tangent.matrix, i);
        const real distance = length(body->x[i]);
        for (int c = 0; c < 3; c++) {
            const double force = (double)(block->column[c][c] * distance) / h;
            noise += (double)body->inverse_mass[i] * force * force;
            block->column[c][c] += body->mass[i] + (real)(h * damping_drag(body, i));
        }
        noise += (double)(body->mass[i] * dot(body->v[i], body->v[i]));
    }
    const bool rebuild = project || linear->levels_h != h;
    multigrid_update(&linear->levels, body->x, rebuild);
    if (rebuild)
        linear->first_products = linear->levels_age = 0;
    linear->levels_age++;
    linear->levels_h = linear->levels_age < LEVELS_AGE_MAX ? h : 0;
    return (double)REAL_EPSILON / 2 * sqrt(noise);
}

double linear_solve_update(LinearSolve* linear, Body* body, double h) {
    return update(linear, body, h, false);
}

/// Held particles neither move nor feel forces.
static void zero_held(const LinearSolve* linear, const Body* body, real4* a) {
    for (int i = 0; linear->has_held && i < body->count; i++)
        if (!(body->inverse_mass[i] > 0))
            a[i] = (real4){0, 0, 0, 0};
}

/// A p
static void multiply(LinearSolve* linear, const Body* body, double h) {
    multigrid_multiply(&linear->levels, linear->direction, linear->image);
    tangent_add_dense(body, h * h, linear->direction, linear->image);
    zero_held(linear, body, linear->image);
}

/// z; returns r . z, the squared residual in the preconditioner's norm.
static double precondition(LinearSolve* linear, const Body* body) {
    const double squared =
        multigrid_apply(&linear->levels, linear->residual, linear->preconditioned);
    zero_held(linear, body, linear->preconditioned); // r is zero there
    return squared;
}

/// False where A is not positive along a search direction.
static bool conjugate_gradients(LinearSolve* linear, const Body* body, double h, double tolerance,
                                const real4* R, real4* dv, int* products) {
    const int n = body->count;
    for (int i = 0; i < n; i++)
        linear->residual[i] = -R[i];
    memset(dv, 0, (size_t)n * sizeof *dv);

    const double norm_max = residual_share_max * inverse_mass_norm(body, R);
    double squared = precondition(linear, body);
    const double squared_max = squared * tolerance * tolerance;
    memcpy(linear->direction, linear->preconditioned, (size_t)n * sizeof *linear->direction);
    for (int k = 0; k < PRODUCTS_MAX && !interrupt_signal(); k++) {
        if (squared <= squared_max && inverse_mass_norm(body, linear->residual) <= norm_max)
            break;
        multiply(linear, body, h);
        ++*products;
        const double curvature = vectors()->dot(linear->direction, linear->image, n);
        if (!(curvature > 0))
            return false;
        const real step = (real)(squared / curvature);
        vectors()->add(dv, step, linear->direction, n);
        vectors()->add(linear->residual, -step, linear->image, n);
        const double previous = squared;
        squared = precondition(linear, body);
        if (!(squared >= 0))
            return false;
        vectors()->scale_add(linear->direction, (real)(squared / previous), linear->preconditioned,
                             n);
    }
    return true;
}

void linear_solve_run(LinearSolve* linear, Body* body, double h, double tolerance, const real4* R,
                      real4* dv, int* products) {
    const int before = *products;
    if (!conjugate_gradients(linear, body, h, tolerance, R, dv, products)) {
        update(linear, body, h, true);
        conjugate_gradients(linear, body, h, tolerance, R, dv, products);
        linear->levels_h = 0;
        return;
    }
    const int used = *products - before;
    if (linear->first_products == 0)
        linear->first_products = used;
    else if (used > products_growth * linear->first_products + products_margin)
        linear->levels_h = 0;
}

void linear_solve_close(LinearSolve* linear) {
    free(linear->residual);
    free(linear->direction);
    free(linear->image);
    free(linear->preconditioned);
    tangent_close(&linear->tangent);
    multigrid_close(&linear->levels);
    *linear = (LinearSolve){0};
}
