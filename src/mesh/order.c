#include "mesh/order.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/group.h"
#include "mesh/mesh.h"

/// The points in ascending order of valence.
static void sort_by_valence(int count, const int* neighbour_from, int* sorted) {
    int* valence = new_array(int, count);
    int most = 0;
    for (int i = 0; i < count; i++) {
        valence[i] = neighbour_from[i + 1] - neighbour_from[i];
        most = valence[i] > most ? valence[i] : most;
    }
    int* from = new_array(int, most + 2);
    group_by_key(valence, count, most + 1, from, sorted);
    free(valence);
    free(from);
}

/// Append the neighbours of a point that are not met yet, around it from where it was met itself.
static int meet_neighbours(int point, const int* neighbour, int valence, int* met_from, int* loaded,
                           int end) {
    int first = 0;
    while (first < valence && neighbour[first] != met_from[point])
        first++;
    for (int k = 0; k < valence; k++) {
        const int other = neighbour[(first + k) % valence];
        if (met_from[other] != NONE)
            continue;
        met_from[other] = point;
        loaded[end++] = other;
    }
    return end;
}

void order_points(int count, const int* neighbour_from, const int* neighbour, int* loaded) {
    int* start = new_array(int, count);
    int* met_from = new_array(int, count);
    for (int i = 0; i < count; i++)
        met_from[i] = NONE;
    sort_by_valence(count, neighbour_from, start);

    // `loaded` is the queue itself: points are numbered in the order in which they are met
    int end = 0;
    for (int s = 0; s < count; s++) {
        if (met_from[start[s]] != NONE)
            continue;
        int head = end;
        met_from[start[s]] = start[s];
        loaded[end++] = start[s];
        for (; head < end; head++) {
            const int point = loaded[head], from = neighbour_from[point];
            end = meet_neighbours(point, &neighbour[from], neighbour_from[point + 1] - from,
                                  met_from, loaded, end);
        }
    }
    free(start);
    free(met_from);
}
