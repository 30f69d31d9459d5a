#include "mesh/edges.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/counting_sort.h"

/// The lower end of each side, NONE for a side that a triangle does not have.
static void lower_ends(const int (*face)[4], int face_count, int* low) {
    for (int side = 0; side < 4 * face_count; side++) {
        if (side_start(face, side) == NONE) {
            low[side] = NONE;
            continue;
        }
        const int start = side_start(face, side);
        const int end = side_end(face, side);
        low[side] = start < end ? start : end;
    }
}

/// first[s]: the first of all sides that join the same two points as side s.
///
/// All these sides have the same lower end. For each lower end in turn, seen[high] is the first
/// side to the higher end `high`; an entry left by an earlier lower end is told by that end.
static void first_sides(const int (*face)[4], int face_count, int point_count, int* first) {
    const int sides = 4 * face_count;
    int* low = new_array(int, sides);
    int* item = new_array(int, sides);
    int* from = new_array(int, point_count + 1);
    int* seen = new_array(int, point_count);

    lower_ends(face, face_count, low);
    counting_sort(low, sides, point_count, from, item);
    for (int i = 0; i < point_count; i++)
        seen[i] = NONE;

    for (int point = 0; point < point_count; point++) {
        for (int i = from[point]; i < from[point + 1]; i++) {
            const int side = item[i];
            const int high = side_start(face, side) + side_end(face, side) - point;
            if (seen[high] == NONE || low[seen[high]] != point)
                seen[high] = side;
            first[side] = seen[high];
        }
    }
    free(low);
    free(item);
    free(from);
    free(seen);
}

void edges_find(Edges* edges, const int (*face)[4], int face_count, int point_count) {
    const int sides = 4 * face_count;
    int* first = new_array(int, sides);
    first_sides(face, face_count, point_count, first);

    *edges = (Edges){
        .end = new_array(int[2], sides),
        .side = new_array(int[2], sides),
        .sides = new_array(int, sides),
        .of_side = new_array(int, sides),
    };
    for (int side = 0; side < sides; side++) {
        if (side_start(face, side) == NONE) {
            edges->of_side[side] = NONE;
            continue;
        }
        if (first[side] == side) {
            const int fresh = edges->count++;
            edges->of_side[side] = fresh;
            edges->end[fresh][0] = side_start(face, side);
            edges->end[fresh][1] = side_end(face, side);
            edges->side[fresh][1] = NONE;
        }
        const int edge = edges->of_side[first[side]];
        edges->of_side[side] = edge;
        if (edges->sides[edge] < 2)
            edges->side[edge][edges->sides[edge]] = side;
        edges->sides[edge]++;
    }
    free(first);
}

void edges_free(Edges* edges) {
    free(edges->end);
    free(edges->side);
    free(edges->sides);
    free(edges->of_side);
    *edges = (Edges){0};
}
