#include "solve/multigrid/transfer.h"

#include <stdlib.h>
#include <string.h>

#include "base/cpu.h"
#include "base/memory.h"
#include "mesh/mesh.h"

/// Share of the neighbors in a node's motion, which is smoothed aggregation's damped Jacobi step on
/// the graph's Laplacian L (Vanek et al.: 4/3 over L's largest eigenvalue). Less where aggregates
/// rotate: their rigid motions fit each other better at the boundaries, so less smoothing is
/// needed. [1]
static const real share_translating = (real)0.9, share_rotating = (real)0.6;

static void make_graph(Transfer* transfer, const BlockMatrix* matrix) {
    const int nodes = transfer->nodes, rows = transfer->rows;
    transfer->neighbor_from = new_array(int, nodes + 1);
    transfer->neighbor = new_array(int, matrix->from[matrix->count]);
    for (int i = 0, count = 0; i < nodes; i++) {
        for (int k = matrix->from[i * rows]; k < matrix->from[i * rows + 1]; k++)
            if (matrix->column[k] % rows == 0)
                transfer->neighbor[count++] = matrix->column[k] / rows;
        transfer->neighbor_from[i + 1] = count;
    }
}

/// Find aggregates of neighbors: aggregate[i] of each node. Returns their number.
static int find_aggregates(const Transfer* transfer, int* aggregate) {
    const int nodes = transfer->nodes;
    const int *from = transfer->neighbor_from, *neighbor = transfer->neighbor;
    int aggregates = 0;
    for (int i = 0; i < nodes; i++)
        aggregate[i] = NONE;

    // a node and its neighbors, where none of them belongs to an aggregate yet
    for (int i = 0; i < nodes; i++) {
        bool all = true;
        for (int k = from[i]; all && k < from[i + 1]; k++)
            all = aggregate[neighbor[k]] == NONE;
        if (!all)
            continue;
        for (int k = from[i]; k < from[i + 1]; k++)
            aggregate[neighbor[k]] = aggregates;
        aggregates++;
    }
    // each remaining node joins a neighbor's aggregate g; -2 - g marks it until all are visited,
    // so that aggregates grow by one layer only
    for (int i = 0; i < nodes; i++)
        for (int k = from[i]; aggregate[i] == NONE && k < from[i + 1]; k++)
            if (aggregate[neighbor[k]] >= 0)
                aggregate[i] = -2 - aggregate[neighbor[k]];
    for (int i = 0; i < nodes; i++)
        if (aggregate[i] < NONE)
            aggregate[i] = -2 - aggregate[i];
        else if (aggregate[i] == NONE)
            aggregate[i] = aggregates++;
    return aggregates;
}

/// Share of node i's k-th neighbor in its motion; the first neighbor is the node itself.
static real share_of(const Transfer* transfer, int i, int k) {
    const int neighbors = transfer->neighbor_from[i + 1] - transfer->neighbor_from[i] - 1;
    const real share = transfer->aggregate_rows > 1 ? share_rotating : share_translating;
    if (neighbors == 0)
        return 1;
    return k == transfer->neighbor_from[i] ? 1 - share : share / (real)neighbors;
}

/// Index of the term for an aggregate among a node's terms, begin ... *end - 1; appended where
/// there is none yet.
static int term_of(const Transfer* transfer, int begin, int* end, int aggregate) {
    int term = begin;
    while (term < *end && transfer->term_aggregate[term] != aggregate)
        term++;
    if (term == *end) {
        transfer->term_aggregate[term] = aggregate;
        (*end)++;
    }
    return term;
}

static void make_terms(Transfer* transfer, const real* inverse_mass) {
    const int nodes = transfer->nodes, terms_max = transfer->neighbor_from[nodes];
    transfer->from = new_array(int, nodes + 1);
    transfer->term_aggregate = new_array(int, terms_max);
    transfer->weight = new_array(real, terms_max);
    for (int i = 0; i < nodes; i++) {
        const int begin = transfer->from[i];
        int end = begin;
        if (!inverse_mass || inverse_mass[i] > 0)
            for (int k = transfer->neighbor_from[i]; k < transfer->neighbor_from[i + 1]; k++) {
                const int g = transfer->aggregate[transfer->neighbor[k]];
                transfer->weight[term_of(transfer, begin, &end, g)] += share_of(transfer, i, k);
            }
        transfer->from[i + 1] = end;
    }
    if (transfer->aggregate_rows > 1)
        transfer->arm = new_array(real4, transfer->from[nodes]);
}

/// One entry of P: the weight w of (t, T) or (r, R), or the arm m of (t, R).
typedef struct Entry {
    int fine, coarse, term;
    bool arm;
} Entry;

static int list(const Transfer* transfer, Entry* entry) {
    const int rows = transfer->rows, aggregate_rows = transfer->aggregate_rows;
    int count = 0;
    for (int i = 0; i < transfer->nodes; i++)
        for (int r = 0; r < rows; r++)
            for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
                for (int c = r; c < aggregate_rows; c++)
                    entry[count++] =
                        (Entry){.fine = i * rows + r,
                                .coarse = transfer->term_aggregate[a] * aggregate_rows + c,
                                .term = a,
                                .arm = c > r};
    return count;
}

/// P, or P^T where `restriction` is true; the entries of a row keep the order of the list.
static void make_slices(TransferSlices* slices, const Transfer* transfer, const Entry* entry,
                        int entries, bool restriction) {
    const int rows = restriction ? transfer->aggregates * transfer->aggregate_rows
                                 : transfer->nodes * transfer->rows;
    const int count = (rows + LANES - 1) / LANES;
    *slices = (TransferSlices){.count = count, .from = new_array(int, count + 1)};
    int* length = new_array(int, count* LANES);
    for (int e = 0; e < entries; e++)
        length[restriction ? entry[e].coarse : entry[e].fine]++;
    for (int s = 0; s < count; s++) {
        int longest = 0;
        for (int k = 0; k < LANES; k++)
            longest = length[s * LANES + k] > longest ? length[s * LANES + k] : longest;
        slices->from[s + 1] = slices->from[s] + longest;
    }
    const int slots = slices->from[count];
    slices->offset = new_array(uint32_t[LANES], slots);
    slices->weight = new_array(real[LANES], slots);
    if (transfer->arm) {
        slices->arm = new_array(real[3][LANES], slots);
        slices->term = new_array(int[LANES], slots);
        for (int k = 0; k < slots * LANES; k++)
            slices->term[k / LANES][k % LANES] = NONE;
    }

    memset(length, 0, (size_t)rows * sizeof *length);
    for (int e = 0; e < entries; e++) {
        const int row = restriction ? entry[e].coarse : entry[e].fine, lane = row % LANES;
        const int other = restriction ? entry[e].fine : entry[e].coarse;
        const int slot = slices->from[row / LANES] + length[row]++;
        slices->offset[slot][lane] = (uint32_t)((size_t)other * sizeof(real4));
        if (entry[e].arm)
            slices->term[slot][lane] = entry[e].term;
        else
            slices->weight[slot][lane] = transfer->weight[entry[e].term];
    }
    free(length);
}

bool transfer_make(Transfer* transfer, const BlockMatrix* matrix, const real* inverse_mass,
                   bool nodes_rotate, bool aggregates_rotate) {
    const int rows = nodes_rotate ? 2 : 1;
    *transfer = (Transfer){
        .nodes = matrix->count / rows, .rows = rows, .aggregate_rows = aggregates_rotate ? 2 : 1};
    make_graph(transfer, matrix);
    transfer->aggregate = new_array(int, transfer->nodes);
    transfer->aggregates = find_aggregates(transfer, transfer->aggregate);
    if (transfer->aggregates == transfer->nodes) {
        transfer_free(transfer);
        return false;
    }
    make_terms(transfer, inverse_mass);
    Entry* entry = new_array(Entry, 4 * transfer->from[transfer->nodes]);
    const int entries = list(transfer, entry);
    make_slices(&transfer->prolongation, transfer, entry, entries, false);
    make_slices(&transfer->restriction, transfer, entry, entries, true);
    free(entry);
    return true;
}

/// Copy the arms to the slices; sign -1 for P^T, whose product is m x f = -(f x m).
static void copy_arms(const Transfer* transfer, real sign, TransferSlices* slices) {
    for (int k = 0; k < slices->from[slices->count] * LANES; k++) {
        const int slot = k / LANES, lane = k % LANES, term = slices->term[slot][lane];
        for (int c = 0; c < 3 && term != NONE; c++)
            slices->arm[slot][c][lane] = sign * transfer->arm[term][c];
    }
}

void transfer_update(Transfer* transfer, const real4* position, real4* aggregate_position) {
    memset(aggregate_position, 0, (size_t)transfer->aggregates * sizeof *aggregate_position);
    for (int i = 0; i < transfer->nodes; i++) // the spare lane counts the nodes
        aggregate_position[transfer->aggregate[i]] += position[i] + (real4){0, 0, 0, 1};
    for (int g = 0; g < transfer->aggregates; g++) {
        aggregate_position[g] /= aggregate_position[g][3];
        aggregate_position[g][3] = 0;
    }
    if (!transfer->arm)
        return;

    memset(transfer->arm, 0, (size_t)transfer->from[transfer->nodes] * sizeof *transfer->arm);
    for (int i = 0; i < transfer->nodes; i++) {
        const int begin = transfer->from[i];
        int end = transfer->from[i + 1];
        for (int k = transfer->neighbor_from[i]; begin < end && k < transfer->neighbor_from[i + 1];
             k++) {
            const int j = transfer->neighbor[k], g = transfer->aggregate[j];
            transfer->arm[term_of(transfer, begin, &end, g)] +=
                share_of(transfer, i, k) * (position[j] - aggregate_position[g]);
        }
    }
    copy_arms(transfer, 1, &transfer->prolongation);
    copy_arms(transfer, -1, &transfer->restriction);
}

static TransferKernel best_kernel(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return transfer_multiply_v3;
#endif
    return transfer_multiply_baseline;
}

void transfer_restrict(const Transfer* transfer, const real4* fine, real4* coarse) {
    best_kernel()(&transfer->restriction, fine, false, coarse);
}

void transfer_prolong(const Transfer* transfer, const real4* coarse, real4* fine) {
    best_kernel()(&transfer->prolongation, coarse, true, fine);
}

static void free_slices(TransferSlices* slices) {
    free(slices->from);
    free(slices->offset);
    free(slices->weight);
    free(slices->arm);
    free(slices->term);
}

void transfer_free(Transfer* transfer) {
    free(transfer->neighbor_from);
    free(transfer->neighbor);
    free(transfer->aggregate);
    free(transfer->from);
    free(transfer->term_aggregate);
    free(transfer->weight);
    free(transfer->arm);
    free_slices(&transfer->prolongation);
    free_slices(&transfer->restriction);
    *transfer = (Transfer){0};
}
