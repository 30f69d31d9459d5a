#include "mesh/orient.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/facet.h"

enum { UNKNOWN = -1, KEPT = 0, FLIPPED = 1 };

/// Below this share of area^(3/2) a volume is rounding, for instance that of two flat sheets. [1]
static const double VOLUME_MIN = 1e-12;

typedef struct Flood {
    const MeshSource* source;
    const Edges* edges;
    signed char* mark; ///< [face_count] UNKNOWN, KEPT or FLIPPED
    int* queue;        ///< [face_count] the faces, component by component
    Orientation orientation;
} Flood;

/// The other side of side s's edge; NONE at a rim and at edges of more than two faces.
static int other_side(const Edges* edges, int s) {
    const int e = edges->of_side[s];
    if (edges->sides[e] != 2)
        return NONE;
    return edges->side[e][0] == s ? edges->side[e][1] : edges->side[e][0];
}

/// Queue all faces of the component of queue[from]; returns their end in the queue.
static int flood(Flood* flood, int from) {
    const int(*face)[4] = (const int(*)[4])flood->source->face;
    int end = from + 1;
    for (int head = from; head < end; head++) {
        const int f = flood->queue[head];
        for (int s = 4 * f; s < 4 * f + face_corners(face[f]); s++) {
            const int t = other_side(flood->edges, s);
            if (t == NONE)
                continue;
            // two faces of one orientation traverse their common edge in opposite directions
            const bool alike = side_start(face, s) == side_end(face, t);
            const signed char mark = alike ? flood->mark[f] : (signed char)(1 - flood->mark[f]);
            const int g = t / 4;
            if (flood->mark[g] == UNKNOWN) {
                flood->mark[g] = mark;
                flood->queue[end++] = g;
            } else if (flood->mark[g] != mark && flood->orientation.clash[0] == NONE) {
                flood->orientation.clash[0] = f;
                flood->orientation.clash[1] = g;
            }
        }
    }
    return end;
}

static int count_flipped(const Flood* flood, int from, int end) {
    int count = 0;
    for (int i = from; i < end; i++)
        count += flood->mark[flood->queue[i]] == FLIPPED;
    return count;
}

static void flip_all(Flood* flood, int from, int end) {
    for (int i = from; i < end; i++)
        flood->mark[flood->queue[i]] = (signed char)(1 - flood->mark[flood->queue[i]]);
}

static bool is_closed(const Flood* flood, int from, int end) {
    for (int i = from; i < end; i++) {
        const int f = flood->queue[i];
        for (int s = 4 * f; s < 4 * f + face_corners(flood->source->face[f]); s++)
            if (flood->edges->sides[flood->edges->of_side[s]] != 2)
                return false;
    }
    return true;
}

/// Whether the component's volume is negative beyond rounding.
static bool is_inside_out(const Flood* flood, int from, int end) {
    const MeshSource* source = flood->source;
    const double4 origin = source->point[source->face[flood->queue[from]][0]];
    double volume = 0;
    double area = 0;
    for (int i = from; i < end; i++) {
        const int f = flood->queue[i];
        const Facet facet = facet_of(source->point, source->face[f]);
        const double part = facet_volume(&facet, origin);
        volume += flood->mark[f] == FLIPPED ? -part : part;
        area += dlength(facet_area(&facet));
    }
    return volume < -VOLUME_MIN * area * sqrt(area);
}

/// Reverse the order of the corners; the first one remains first.
static void flip_face(int face[4]) {
    const int last = face_corners(face) - 1;
    const int swap = face[1];
    face[1] = face[last];
    face[last] = swap;
}

Orientation orient_faces(MeshSource* source, const Edges* edges) {
    const int count = source->face_count;
    Flood state = {
        .source = source,
        .edges = edges,
        .mark = new_array(signed char, count),
        .queue = new_array(int, count),
        .orientation = {.clash = {NONE, NONE}},
    };
    for (int f = 0; f < count; f++)
        state.mark[f] = UNKNOWN;

    int from = 0;
    for (int f = 0; f < count; f++) {
        if (state.mark[f] != UNKNOWN)
            continue;
        state.mark[f] = KEPT;
        state.queue[from] = f;
        const int end = flood(&state, from);
        state.orientation.components++;

        // flip the minority of an open skin; orient a closed one outward
        if (2 * count_flipped(&state, from, end) > end - from)
            flip_all(&state, from, end);
        if (is_closed(&state, from, end) && is_inside_out(&state, from, end))
            flip_all(&state, from, end);
        from = end;
    }

    for (int f = 0; f < count; f++) {
        if (state.mark[f] == FLIPPED)
            flip_face(source->face[f]);
        state.orientation.flipped += state.mark[f] == FLIPPED;
    }
    free(state.mark);
    free(state.queue);
    return state.orientation;
}
