#include "mesh/reorder.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/counting_sort.h"
#include "mesh/mesh.h"

/// The points in ascending order of valence.
static void sort_by_valence(int count, const int* neighbor_from, int* sorted) {
    int* valence = new_array(int, count);
    int valence_max = 0;
    for (int i = 0; i < count; i++) {
        valence[i] = neighbor_from[i + 1] - neighbor_from[i];
        valence_max = valence[i] > valence_max ? valence[i] : valence_max;
    }
    int* from = new_array(int, valence_max + 2);
    counting_sort(valence, count, valence_max + 1, from, sorted);
    free(valence);
    free(from);
}

/// Append the neighbors of a point that have no number yet, in order around it, beginning with the
/// one that it was reached from.
static int reach_neighbors(int point, const int* neighbor, int valence, int* reached_from,
                           int* loaded, int end) {
    int first = 0;
    while (first < valence && neighbor[first] != reached_from[point])
        first++;
    for (int k = 0; k < valence; k++) {
        const int other = neighbor[(first + k) % valence];
        if (reached_from[other] != NONE)
            continue;
        reached_from[other] = point;
        loaded[end++] = other;
    }
    return end;
}

void reorder_points(int count, const int* neighbor_from, const int* neighbor, int* loaded) {
    int* start = new_array(int, count);
    int* reached_from = new_array(int, count);
    for (int i = 0; i < count; i++)
        reached_from[i] = NONE;
    sort_by_valence(count, neighbor_from, start);

    // `loaded` is the queue: points are numbered in the order in which they are reached
    int end = 0;
    for (int s = 0; s < count; s++) {
        if (reached_from[start[s]] != NONE)
            continue;
        int head = end;
        reached_from[start[s]] = start[s];
        loaded[end++] = start[s];
        for (; head < end; head++) {
            const int point = loaded[head], from = neighbor_from[point];
            end = reach_neighbors(point, &neighbor[from], neighbor_from[point + 1] - from,
                                  reached_from, loaded, end);
        }
    }
    free(start);
    free(reached_from);
}
