#include "solve/multigrid/transfer.h"

#include <stdlib.h>
#include <string.h>

#include "base/cpu.h"
#include "base/memory.h"
#include "mesh/mesh.h"

/// The neighbours' share: 4/3 over the largest of the graph's Laplacian. Less where groups turn,
/// for then their motions meet at the edges as they are. [1]
static const real share_going = (real)0.9, share_turning = (real)0.6;

static void make_graph(Transfer* transfer, const BlockMatrix* matrix) {
    const int nodes = transfer->nodes, rows = transfer->rows;
    transfer->near_from = new_array(int, nodes + 1);
    transfer->near = new_array(int, matrix->from[matrix->count]);
    for (int i = 0, count = 0; i < nodes; i++) {
        for (int k = matrix->from[i * rows]; k < matrix->from[i * rows + 1]; k++)
            if (matrix->column[k] % rows == 0)
                transfer->near[count++] = matrix->column[k] / rows;
        transfer->near_from[i + 1] = count;
    }
}

/// Groups of neighbours: group[i] of each node. Returns their number.
static int aggregate(const Transfer* transfer, int* group) {
    const int nodes = transfer->nodes;
    const int *from = transfer->near_from, *near = transfer->near;
    int groups = 0;
    for (int i = 0; i < nodes; i++)
        group[i] = NONE;

    // a node whose neighbours are all free, and these neighbours
    for (int i = 0; i < nodes; i++) {
        bool all = true;
        for (int k = from[i]; all && k < from[i + 1]; k++)
            all = group[near[k]] == NONE;
        if (!all)
            continue;
        for (int k = from[i]; k < from[i + 1]; k++)
            group[near[k]] = groups;
        groups++;
    }
    // what is left lies between groups, and joins one; -2 - g until all have looked
    for (int i = 0; i < nodes; i++)
        for (int k = from[i]; group[i] == NONE && k < from[i + 1]; k++)
            if (group[near[k]] >= 0)
                group[i] = -2 - group[near[k]];
    for (int i = 0; i < nodes; i++)
        if (group[i] < NONE)
            group[i] = -2 - group[i];
        else if (group[i] == NONE)
            group[i] = groups++;
    return groups;
}

/// The share of a node's k-th neighbour in its motion, of which it is the first itself.
static real share_of(const Transfer* transfer, int i, int k) {
    const int neighbours = transfer->near_from[i + 1] - transfer->near_from[i] - 1;
    const real share = transfer->group_rows > 1 ? share_turning : share_going;
    if (neighbours == 0)
        return 1;
    return k == transfer->near_from[i] ? 1 - share : share / (real)neighbours;
}

/// Where a group is in a node's parts, from `begin` on; a new one at their end.
static int part_of(const Transfer* transfer, int begin, int* end, int group) {
    int part = begin;
    while (part < *end && transfer->coarse[part] != group)
        part++;
    if (part == *end) {
        transfer->coarse[part] = group;
        (*end)++;
    }
    return part;
}

static void make_parts(Transfer* transfer, const real* inverse_mass) {
    const int nodes = transfer->nodes, most = transfer->near_from[nodes];
    transfer->from = new_array(int, nodes + 1);
    transfer->coarse = new_array(int, most);
    transfer->weight = new_array(real, most);
    for (int i = 0; i < nodes; i++) {
        const int begin = transfer->from[i];
        int end = begin;
        if (!inverse_mass || inverse_mass[i] > 0)
            for (int k = transfer->near_from[i]; k < transfer->near_from[i + 1]; k++) {
                const int g = transfer->group[transfer->near[k]];
                transfer->weight[part_of(transfer, begin, &end, g)] += share_of(transfer, i, k);
            }
        transfer->from[i + 1] = end;
    }
    if (transfer->group_rows > 1)
        transfer->arm = new_array(real4, transfer->from[nodes]);
}

/// One entry of P: w of t and T or of r and R, m of t and R.
typedef struct Entry {
    int fine, coarse, part;
    bool arm;
} Entry;

static int list(const Transfer* transfer, Entry* entry) {
    const int rows = transfer->rows, group_rows = transfer->group_rows;
    int count = 0;
    for (int i = 0; i < transfer->nodes; i++)
        for (int r = 0; r < rows; r++)
            for (int a = transfer->from[i]; a < transfer->from[i + 1]; a++)
                for (int c = r; c < group_rows; c++)
                    entry[count++] = (Entry){.fine = i * rows + r,
                                             .coarse = transfer->coarse[a] * group_rows + c,
                                             .part = a,
                                             .arm = c > r};
    return count;
}

/// Rows of P in the order of the list; `down`: of P^T.
static void make_sums(Sums* sums, const Transfer* transfer, const Entry* entry, int entries,
                      bool down) {
    const int rows =
        down ? transfer->groups * transfer->group_rows : transfer->nodes * transfer->rows;
    const int count = (rows + LANES - 1) / LANES;
    *sums = (Sums){.count = count, .from = new_array(int, count + 1)};
    int* length = new_array(int, count* LANES);
    for (int e = 0; e < entries; e++)
        length[down ? entry[e].coarse : entry[e].fine]++;
    for (int s = 0; s < count; s++) {
        int longest = 0;
        for (int k = 0; k < LANES; k++)
            longest = length[s * LANES + k] > longest ? length[s * LANES + k] : longest;
        sums->from[s + 1] = sums->from[s] + longest;
    }
    const int slots = sums->from[count];
    sums->place = new_array(uint32_t[LANES], slots);
    sums->weight = new_array(real[LANES], slots);
    if (transfer->arm) {
        sums->arm = new_array(real[3][LANES], slots);
        sums->part = new_array(int[LANES], slots);
        for (int k = 0; k < slots * LANES; k++)
            sums->part[k / LANES][k % LANES] = NONE;
    }

    memset(length, 0, (size_t)rows * sizeof *length);
    for (int e = 0; e < entries; e++) {
        const int row = down ? entry[e].coarse : entry[e].fine, lane = row % LANES;
        const int other = down ? entry[e].fine : entry[e].coarse;
        const int slot = sums->from[row / LANES] + length[row]++;
        sums->place[slot][lane] = (uint32_t)((size_t)other * sizeof(real4));
        if (entry[e].arm)
            sums->part[slot][lane] = entry[e].part;
        else
            sums->weight[slot][lane] = transfer->weight[entry[e].part];
    }
    free(length);
}

bool transfer_make(Transfer* transfer, const BlockMatrix* matrix, const real* inverse_mass,
                   bool turned, bool turns) {
    const int rows = turned ? 2 : 1;
    *transfer =
        (Transfer){.nodes = matrix->count / rows, .rows = rows, .group_rows = turns ? 2 : 1};
    make_graph(transfer, matrix);
    transfer->group = new_array(int, transfer->nodes);
    transfer->groups = aggregate(transfer, transfer->group);
    if (transfer->groups == transfer->nodes) {
        transfer_free(transfer);
        return false;
    }
    make_parts(transfer, inverse_mass);
    Entry* entry = new_array(Entry, 4 * transfer->from[transfer->nodes]);
    const int entries = list(transfer, entry);
    make_sums(&transfer->up, transfer, entry, entries, false);
    make_sums(&transfer->down, transfer, entry, entries, true);
    free(entry);
    return true;
}

/// The arms' present values; sign -1 for P^T, where m x f is to come out.
static void take_arms(const Transfer* transfer, real sign, Sums* sums) {
    for (int k = 0; k < sums->from[sums->count] * LANES; k++) {
        const int slot = k / LANES, lane = k % LANES, part = sums->part[slot][lane];
        for (int c = 0; c < 3 && part != NONE; c++)
            sums->arm[slot][c][lane] = sign * transfer->arm[part][c];
    }
}

void transfer_place(Transfer* transfer, const real4* place, real4* group_place) {
    memset(group_place, 0, (size_t)transfer->groups * sizeof *group_place);
    for (int i = 0; i < transfer->nodes; i++) // the spare lane counts
        group_place[transfer->group[i]] += place[i] + (real4){0, 0, 0, 1};
    for (int g = 0; g < transfer->groups; g++) {
        group_place[g] /= group_place[g][3];
        group_place[g][3] = 0;
    }
    if (!transfer->arm)
        return;

    memset(transfer->arm, 0, (size_t)transfer->from[transfer->nodes] * sizeof *transfer->arm);
    for (int i = 0; i < transfer->nodes; i++) {
        const int begin = transfer->from[i];
        int end = transfer->from[i + 1];
        for (int k = transfer->near_from[i]; begin < end && k < transfer->near_from[i + 1]; k++) {
            const int j = transfer->near[k], g = transfer->group[j];
            transfer->arm[part_of(transfer, begin, &end, g)] +=
                share_of(transfer, i, k) * (place[j] - group_place[g]);
        }
    }
    take_arms(transfer, 1, &transfer->up);
    take_arms(transfer, -1, &transfer->down);
}

static SumsKernel sum(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return sums_v3;
#endif
    return sums_baseline;
}

void transfer_restrict(const Transfer* transfer, const real4* fine, real4* coarse) {
    sum()(&transfer->down, fine, false, coarse);
}

void transfer_prolong(const Transfer* transfer, const real4* coarse, real4* fine) {
    sum()(&transfer->up, coarse, true, fine);
}

static void free_sums(Sums* sums) {
    free(sums->from);
    free(sums->place);
    free(sums->weight);
    free(sums->arm);
    free(sums->part);
}

void transfer_free(Transfer* transfer) {
    free(transfer->near_from);
    free(transfer->near);
    free(transfer->group);
    free(transfer->from);
    free(transfer->coarse);
    free(transfer->weight);
    free(transfer->arm);
    free_sums(&transfer->up);
    free_sums(&transfer->down);
    *transfer = (Transfer){0};
}
