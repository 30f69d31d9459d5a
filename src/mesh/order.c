#include "mesh/order.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/group.h"

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

void order_points(int count, const int* neighbour_from, const int* neighbour, int* loaded) {
    int* start = new_array(int, count);
    char* met = new_array(char, count);
    sort_by_valence(count, neighbour_from, start);

    // `loaded` is the queue itself: points are numbered in the order in which they are met
    int end = 0;
    for (int s = 0; s < count; s++) {
        if (met[start[s]])
            continue;
        int head = end;
        met[start[s]] = 1;
        loaded[end++] = start[s];
        for (; head < end; head++) {
            const int point = loaded[head];
            for (int n = neighbour_from[point]; n < neighbour_from[point + 1]; n++) {
                if (met[neighbour[n]])
                    continue;
                met[neighbour[n]] = 1;
                loaded[end++] = neighbour[n];
            }
        }
    }
    free(start);
    free(met);
}
