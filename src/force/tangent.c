#include "force/tangent.h"

#include <stdlib.h>

#include "base/memory.h"

static Stencils stencils_of(const Force* force, const Body* body) {
    return force->stencils ? force->stencils(body) : (Stencils){0};
}

/// (row, column) of every two particles in a stencil, with repetitions. Returns their number; with
/// pair NULL, only counts.
static int collect(const Body* body, int (*pair)[2]) {
    int count = 0;
    for (int f = 0; f < force_count; f++) {
        const Stencils all = stencils_of(force_table[f], body);
        for (int s = 0; s < all.count; s++) {
            const int* particle = &all.particle[s * all.corners];
            for (int i = 0; i < all.corners && particle[i] != NONE; i++)
                for (int j = 0; j < all.corners && particle[j] != NONE; j++, count++)
                    if (pair) {
                        pair[count][0] = particle[i];
                        pair[count][1] = particle[j];
                    }
        }
    }
    return count;
}

static int* find_blocks(const BlockMatrix* matrix, const Stencils* all) {
    int* block_at = new_array(int, all->count * all->corners * all->corners);
    for (int s = 0, k = 0; s < all->count; s++) {
        const int* particle = &all->particle[s * all->corners];
        for (int i = 0; i < all->corners; i++)
            for (int j = 0; j < all->corners; j++)
                block_at[k++] = particle[i] == NONE || particle[j] == NONE
                                    ? NONE
                                    : block_matrix_find(matrix, particle[i], particle[j]);
    }
    return block_at;
}

void tangent_open(Tangent* tangent, const Body* body) {
    const int pairs = collect(body, NULL);
    int(*pair)[2] = new_array(int[2], pairs);
    collect(body, pair);
    block_matrix_make(&tangent->matrix, body->count, (const int(*)[2])pair, pairs);
    free(pair);

    tangent->block_at = new_array(int*, force_count);
    for (int f = 0; f < force_count; f++) {
        const Stencils all = stencils_of(force_table[f], body);
        if (all.count > 0)
            tangent->block_at[f] = find_blocks(&tangent->matrix, &all);
    }
}

void tangent_update(Tangent* tangent, Body* body, double factor, bool project) {
    block_matrix_clear(&tangent->matrix);
    for (int f = 0; f < force_count; f++) {
        const Force* force = force_table[f];
        if (!force->present(body))
            continue;
        if (force->update_tangent)
            force->update_tangent(body, project);
        if (force->assemble)
            force->assemble(body, factor, project, tangent->block_at[f], &tangent->matrix);
    }
}

void tangent_multiply(const Tangent* tangent, const Body* body, double factor, const real4* d,
                      real4* out) {
    block_matrix_multiply(&tangent->matrix, d, out);
    tangent_add_dense(body, factor, d, out);
}

void tangent_add_dense(const Body* body, double factor, const real4* d, real4* out) {
    for (int f = 0; f < force_count; f++)
        if (force_table[f]->product && force_table[f]->present(body))
            force_table[f]->product(body, factor, d, out);
}

void tangent_close(Tangent* tangent) {
    block_matrix_free(&tangent->matrix);
    if (tangent->block_at)
        for (int f = 0; f < force_count; f++)
            free(tangent->block_at[f]);
    free(tangent->block_at);
    *tangent = (Tangent){0};
}
