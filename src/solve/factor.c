#include "solve/factor.h"

#include <stdlib.h>
#include <string.h>
#include <suitesparse/cholmod.h>

#include "base/memory.h"
#include "force/damping.h"

enum { RUNGS = 16 }; ///< steps below h1 / 181 use the last: their A is nearly M

/// x, y, z and a column of zeros: with fewer than four CHOLMOD reallocates its workspace at every
/// solve.
enum { COLUMNS = 4 };

struct Factor {
    cholmod_common common;
    cholmod_factor* pattern;              ///< symbolic analysis
    cholmod_factor* rung[RUNGS];          ///< rung k: for the step h1 2^(-k/2)
    cholmod_factor* selected;             ///< one of the rungs
    double longest;                       ///< h1 [s]
    double damping[FORCE_PARAMETERS_MAX]; ///< the force's parameters, of all rungs
    int string_count;                     ///< of all rungs
    cholmod_dense* right;
    cholmod_dense* solution;
    cholmod_dense* workspace[2]; ///< CHOLMOD's own
};

Factor* factor_open(const Body* body) {
    Factor* factor = new_array(Factor, 1);
    cholmod_common* common = &factor->common;
    cholmod_start(common);
    common->print = 0;
    common->supernodal = CHOLMOD_SIMPLICIAL;
    common->nmethods = 1; // one ordering instead of the best of several
    common->method[0].ordering = CHOLMOD_AMD;
    factor->right = cholmod_zeros((size_t)body->count, COLUMNS, CHOLMOD_REAL, common);
    return factor;
}

static void add_entry(cholmod_triplet* list, int row, int column, double value) {
    ((int*)list->i)[list->nnz] = row > column ? row : column;
    ((int*)list->j)[list->nnz] = row > column ? column : row;
    ((double*)list->x)[list->nnz] = value;
    list->nnz++;
}

/// A's lower triangle; the row of a held particle is that of the identity. CHOLMOD adds repeated
/// entries.
static cholmod_sparse* matrix_of(cholmod_common* common, const Body* body, double h) {
    const Springs* springs = &body->springs;
    const size_t n = (size_t)body->count;
    const size_t entries_max = n + 3 * (size_t)springs->count + (size_t)body->string_count;
    cholmod_triplet* list = cholmod_allocate_triplet(n, n, entries_max, -1, CHOLMOD_REAL, common);
    if (!list)
        return NULL;
    for (int i = 0; i < body->count; i++)
        add_entry(list, i, i,
                  body->inverse_mass[i] > 0 ? (double)body->mass[i] + h * damping_drag(body, i)
                                            : 1);
    for (int s = 0; s < springs->count; s++) {
        const int* end = springs->end[s];
        const double k = h * h * (double)springs->stiffness[s];
        const bool free[2] = {body->inverse_mass[end[0]] > 0, body->inverse_mass[end[1]] > 0};
        for (int e = 0; e < 2; e++)
            if (free[e])
                add_entry(list, end[e], end[e], k);
        if (free[0] && free[1])
            add_entry(list, end[0], end[1], -k);
    }
    for (int k = 0; k < body->string_count; k++) {
        const String* string = &body->string[k];
        if (body->inverse_mass[string->particle] > 0)
            add_entry(list, string->particle, string->particle, h * h * (double)string->stiffness);
    }
    cholmod_sparse* matrix = cholmod_triplet_to_sparse(list, list->nnz, common);
    cholmod_free_triplet(&list, common);
    return matrix;
}

/// Factors of A(h), or NULL.
static cholmod_factor* factorize(Factor* factor, const Body* body, double h) {
    cholmod_common* common = &factor->common;
    cholmod_sparse* matrix = matrix_of(common, body, h);
    if (!matrix)
        return NULL;
    if (!factor->pattern)
        factor->pattern = cholmod_analyze(matrix, common);
    cholmod_factor* made = factor->pattern ? cholmod_copy_factor(factor->pattern, common) : NULL;
    if (made)
        cholmod_factorize(matrix, made, common);
    if (made && common->status != CHOLMOD_OK)
        cholmod_free_factor(&made, common);
    cholmod_free_sparse(&matrix, common);
    return made;
}

/// Whether the existing rungs serve this body and step.
static bool is_current(const Factor* factor, const Body* body, double h) {
    const double* damping = body->force_parameter[FORCE_DAMPING];
    return h <= factor->longest &&
           factor->damping[DAMPING_COEFFICIENT] == damping[DAMPING_COEFFICIENT] &&
           factor->damping[DAMPING_RATE] == damping[DAMPING_RATE] &&
           factor->string_count == body->string_count;
}

static void reset_rungs(Factor* factor, const Body* body, double h) {
    for (int k = 0; k < RUNGS; k++)
        cholmod_free_factor(&factor->rung[k], &factor->common);
    factor->longest = fmax(h, factor->longest);
    memcpy(factor->damping, body->force_parameter[FORCE_DAMPING], sizeof factor->damping);
    factor->string_count = body->string_count;
}

bool factor_select(Factor* factor, const Body* body, double h, int* made) {
    *made = 0;
    if (!is_current(factor, body, h))
        reset_rungs(factor, body, h);
    int k = 0;
    double rung = factor->longest;
    while (k + 1 < RUNGS && rung * sqrt(0.5) >= h) {
        rung *= sqrt(0.5);
        k++;
    }
    if (!factor->rung[k]) {
        factor->rung[k] = factorize(factor, body, rung);
        *made = 1;
    }
    factor->selected = factor->rung[k];
    return factor->selected != NULL;
}

double* factor_right(Factor* factor) {
    return factor->right->x;
}

const double* factor_solve(Factor* factor) {
    const bool good =
        cholmod_solve2(CHOLMOD_A, factor->selected, factor->right, NULL, &factor->solution, NULL,
                       &factor->workspace[0], &factor->workspace[1], &factor->common);
    return good ? factor->solution->x : NULL;
}

void factor_close(Factor* factor) {
    if (!factor)
        return;
    cholmod_common* common = &factor->common;
    for (int k = 0; k < RUNGS; k++)
        cholmod_free_factor(&factor->rung[k], common);
    cholmod_free_factor(&factor->pattern, common);
    cholmod_free_dense(&factor->right, common);
    cholmod_free_dense(&factor->solution, common);
    for (int k = 0; k < 2; k++)
        cholmod_free_dense(&factor->workspace[k], common);
    cholmod_finish(common);
    free(factor);
}
