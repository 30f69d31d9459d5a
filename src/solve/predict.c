#include "solve/predict.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "force/damping.h"
#include "force/force.h"
#include "mesh/measure.h"
#include "solve/residual.h"

enum { ROOT_ITERATIONS_MAX = 100 };

/// The search for a volume begins at no less than this share of the first volume. [1]
static const double volume_share_min = 1e-6;

static bool always(const Body* body) {
    (void)body;
    return true;
}

static bool has_gas(const Body* body) {
    return body->inflation.law == INFLATE_GAS;
}

/// Springs, strings and gas are constraints, drag is in the mass; the rest is explicit at x + u0.
const ForceUse predict_forces[] = {
    {&force_gravity, NULL},   {&force_helium, NULL},
    {&force_lift, NULL},      {&force_inflation, has_gas},
    {&force_springs, always}, {&force_strings, always},
    {&force_damping, always}, {NULL, NULL},
};

void predict_open(Predict* predict, const Body* body) {
    *predict = (Predict){
        .u = new_array(real4, body->count),
        .ahead = new_array(real4, body->count),
        .next = new_array(real4, body->count),
        .weight = new_array(real, body->count),
    };
}

static bool is_replaced(const Force* force, const Body* body) {
    const ForceUse* use = predict_forces;
    while (use->force && use->force != force)
        use++;
    return use->force && use->replaced && use->replaced(body);
}

/// ahead = x + u0; x where x + u0 would turn a gas-filled skin inside out.
static void move_ahead(Predict* predict, const Body* body) {
    for (int i = 0; i < body->count; i++)
        predict->ahead[i] = body->x[i] + predict->u[i];
    if (has_gas(body) && !(measure_volume(body->mesh, predict->ahead) > 0))
        memcpy(predict->ahead, body->x, (size_t)body->count * sizeof *body->x);
}

void predict_begin(Predict* predict, Body* body, double h) {
    for (int i = 0; i < body->count; i++) {
        const real mass = body->mass[i] + (real)(h * damping_drag(body, i));
        predict->weight[i] = body->inverse_mass[i] > 0 ? 1 / mass : 0;
        const bool moves = body->inverse_mass[i] > 0; // what holds another particle may move it
        predict->u[i] =
            (moves ? (real)h * predict->weight[i] * body->mass[i] : (real)h) * body->v[i];
    }
    move_ahead(predict, body);

    // forces at `ahead`: swap the body's positions for the force table
    real4* const x = body->x;
    body->x = predict->ahead;
    memset(body->f, 0, (size_t)body->count * sizeof *body->f);
    for (int k = 0; k < force_count; k++) // in the table's order, for the same bits
        if (force_table[k]->present(body) && !is_replaced(force_table[k], body))
            force_add(force_table[k], body);
    if (has_gas(body))
        measure_volume_gradient(body->mesh, body->x, body->inflation.gradient);
    body->x = x;

    for (int i = 0; i < body->count; i++)
        predict->u[i] += ((real)(h * h) * predict->weight[i]) * body->f[i];
}

double predict_volume(Predict* predict, const Body* body) {
    for (int i = 0; i < body->count; i++)
        predict->ahead[i] = body->x[i] + predict->u[i];
    return measure_volume(body->mesh, predict->ahead);
}

/// Newton's method for the root of V' - volume - weight (h^2 p(V') - impulse), which grows with V'
/// and is concave: from below the root the iterates increase to it; a step from above that would
/// end below 0 becomes a halving.
double predict_pressure(const Inflation* gas, double volume, double weight, double h2,
                        double impulse) {
    double root = fmax(volume, volume_share_min * gas->first_volume);
    for (int n = 0; n < ROOT_ITERATIONS_MAX; n++) {
        const double excess = root - volume - weight * (h2 * gas_pressure(gas, root) - impulse);
        const double next = root - excess / (1 - weight * h2 * gas_slope(gas, root));
        const double change = next > 0 ? next - root : -root / 2;
        root += change;
        if (!(fabs(change) > 1e-15 * root))
            break;
    }
    return gas_pressure(gas, root);
}

/// Relative residual of the step u.
static double step_residual(Predict* predict, Body* body, double h) {
    for (int i = 0; i < body->count; i++) {
        predict->ahead[i] = body->x[i] + predict->u[i];
        predict->next[i] = predict->u[i] / (real)h;
    }
    // the body at the end of the step
    real4 *const x = body->x, *const v = body->v;
    body->x = predict->ahead, body->v = predict->next;
    const double residual = residual_of_step(body, v, h);
    body->x = x, body->v = v;
    return residual;
}

bool predict_is_solved(Predict* predict, Body* body, double h, double residual_max) {
    StepCheck* check = &predict->check;
    check->age++;
    check->seconds += h;
    if (!(residual_max > 0) ||
        (h <= check->longest && check->age < CHECK_INTERVAL && check->seconds < CHECK_SECONDS))
        return true;
    *check = (StepCheck){.residual = step_residual(predict, body, h)};
    if (!(check->residual <= residual_max)) // written so that a NaN fails
        return false;
    check->longest = h;
    return true;
}

void predict_end(const Predict* predict, Body* body, double h) {
    for (int i = 0; i < body->count; i++) {
        const real4 v = predict->u[i] / (real)h;
        body->f[i] = (body->mass[i] / (real)h) * (v - body->v[i]);
        body->v[i] = v;
    }
}

void predict_close(Predict* predict) {
    free(predict->u);
    free(predict->ahead);
    free(predict->next);
    free(predict->weight);
    *predict = (Predict){0};
}
