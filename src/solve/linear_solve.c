#include "solve/linear_solve.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/interrupt.h"
#include "base/memory.h"
#include "force/damping.h"
#include "solve/group_vector.h"

enum {
    PRODUCTS_MAX = 2000,    ///< of one solve
    LEVELS_AGE_MAX = 40,    ///< tangents for which coarse levels are kept
    PRESSURE_ROUNDINGS = 16 ///< of n R T / V: of the volume's sum most; measured up to 10
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

/// Square of the rounding error of a gas's force, over that of positions: the gauge pressure is a
/// difference of absolute pressures, computed in double. At rest in air it is all that remains of R.
static double gas_noise(const Body* body, double h) {
    const Inflation* gas = &body->inflation;
    if (gas->law != INFLATE_GAS)
        return 0;
    const double pressure = PRESSURE_ROUNDINGS * (gas->ambient + fabs(gas->pressure));
    double squared = 0; // of dV/dx
    for (int i = 0; i < body->count; i++)
        squared += (double)(body->inverse_mass[i] * dot(gas->gradient[i], gas->gradient[i]));
    const double force = DBL_EPSILON / (double)REAL_EPSILON * pressure * h;
    return force * force * squared;
}

/// A of one body without contacts; with `project`, K's blocks are replaced by their positive parts.
/// Returns the square of the rounding error's part.
static double assemble(const GroupBody* part, double h, bool project) {
    LinearSolve* linear = part->linear;
    Body* body = part->body;
    tangent_update(&linear->tangent, body, h * h, project);
    double noise = gas_noise(body, h);
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
    return noise;
}

static void update_levels(const GroupBody* part, double h, bool project) {
    LinearSolve* linear = part->linear;
    const bool rebuild = project || linear->levels_h != h;
    multigrid_update(&linear->levels, part->body->x, rebuild);
    if (rebuild)
        linear->first_products = linear->levels_age = 0;
    linear->levels_age++;
    linear->levels_h = linear->levels_age < LEVELS_AGE_MAX ? h : 0;
}

/// Contacts join the finest level only. There a term of one node keeps the smoother convergent; on
/// coarser levels it would couple more rows than the relaxation factor allows, and the levels would
/// have to follow each contact that opens or closes.
static void add_contacts(Group* group) {
    if (!(group->term[0].stiffness > 0))
        contact_terms_begin(group);
    contact_terms_assemble(group);
    for (int k = 0; k < group->body_count; k++)
        multigrid_update(&group->body[k].linear->levels, group->body[k].body->x, false);
}

static double update(Group* group, double h, bool project) {
    double noise = 0;
    for (int k = 0; k < group->body_count; k++)
        noise += assemble(&group->body[k], h, project);
    joint_terms_assemble(group);
    for (int k = 0; k < group->body_count; k++)
        update_levels(&group->body[k], h, project);
    if (group->term_count > 0) {
        add_contacts(group);
        noise += contact_terms_noise(group);
    } else if (group->ball_count > 0) { // knots
        contact_terms_assemble(group);
    }
    return (double)REAL_EPSILON / 2 * sqrt(noise);
}

double linear_solve_update(Group* group, double h) {
    return update(group, h, false);
}

/// Held particles neither move nor feel forces.
static void zero_held(const LinearSolve* linear, const Body* body, real4* a) {
    for (int i = 0; linear->has_held && i < body->count; i++)
        if (!(body->inverse_mass[i] > 0))
            a[i] = (real4){0, 0, 0, 0};
}

/// A p
static void multiply(Group* group, double h) {
    for (int k = 0; k < group->body_count; k++) {
        const GroupBody* part = &group->body[k];
        LinearSolve* linear = part->linear;
        multigrid_multiply(&linear->levels, linear->direction, linear->image);
        tangent_add_dense(part->body, h * h, linear->direction, linear->image);
        zero_held(linear, part->body, linear->image);
    }
    contact_terms_multiply(group);
    joint_terms_multiply(group);
}

/// z; returns r . z, the squared residual in the preconditioner's norm.
static double precondition(Group* group) {
    double squared = 0;
    for (int k = 0; k < group->body_count; k++) {
        LinearSolve* linear = group->body[k].linear;
        squared += multigrid_apply(&linear->levels, linear->residual, linear->preconditioned);
        zero_held(linear, group->body[k].body, linear->preconditioned); // r is zero there
    }
    return squared + contact_terms_precondition(group);
}

/// False where A is not positive along a search direction.
static bool conjugate_gradients(Group* group, double h, double tolerance, int* products) {
    group_set(group, GROUP_REMAINDER, -1, GROUP_RESIDUAL);
    group_clear(group, GROUP_CHANGE);

    const double norm_max = residual_share_max * group_inverse_mass_norm(group, GROUP_RESIDUAL);
    double squared = precondition(group);
    const double squared_max = squared * tolerance * tolerance;
    group_set(group, GROUP_DIRECTION, 1, GROUP_PRECONDITIONED);
    for (int k = 0; k < PRODUCTS_MAX && !interrupt_signal(); k++) {
        if (squared <= squared_max && group_inverse_mass_norm(group, GROUP_REMAINDER) <= norm_max)
            break;
        multiply(group, h);
        ++*products;
        const double curvature = group_dot(group, GROUP_DIRECTION, GROUP_IMAGE);
        if (!(curvature > 0))
            return false;
        const double step = squared / curvature;
        group_add(group, GROUP_CHANGE, step, GROUP_DIRECTION);
        group_add(group, GROUP_REMAINDER, -step, GROUP_IMAGE);
        const double previous = squared;
        squared = precondition(group);
        if (!(squared >= 0))
            return false;
        group_scale_add(group, GROUP_DIRECTION, squared / previous, GROUP_PRECONDITIONED);
    }
    return true;
}

void linear_solve_run(Group* group, double h, double tolerance, int* products) {
    const int before = *products;
    if (!conjugate_gradients(group, h, tolerance, products)) {
        update(group, h, true);
        conjugate_gradients(group, h, tolerance, products);
        for (int k = 0; k < group->body_count; k++)
            group->body[k].linear->levels_h = 0;
        return;
    }
    const int used = *products - before;
    for (int k = 0; k < group->body_count; k++) {
        LinearSolve* linear = group->body[k].linear;
        if (linear->first_products == 0)
            linear->first_products = used;
        else if (used > products_growth * linear->first_products + products_margin)
            linear->levels_h = 0;
    }
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
