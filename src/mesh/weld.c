#include "mesh/weld.h"

#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "base/memory.h"
#include "mesh/edges.h"
#include "mesh/disjoint_sets.h"

typedef int (*Faces)[4];
typedef const int (*ConstFaces)[4];

static int edges_of_one_side(const Edges* edges) {
    int count = 0;
    for (int e = 0; e < edges->count; e++)
        count += edges->sides[e] == 1;
    return count;
}

static int edges_of_many_sides(const Edges* edges) {
    int count = 0;
    for (int e = 0; e < edges->count; e++)
        count += edges->sides[e] > 2;
    return count;
}

static bool same_position(double4 a, double4 b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static size_t position_hash(double4 p) {
    // adding zero makes +0 of -0, which is the same position
    const double at[3] = {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
    const uint64_t hash = hash_bytes(HASH_START, at, sizeof at);
    return (size_t)(hash ^ hash >> 32);
}

/// first[i] of a rim point: the first rim point at its position; of another point: i.
static int* first_at_positions(const MeshSource* source, const Edges* edges, int rim_edges) {
    size_t size = 8;
    while (size < 4 * (size_t)rim_edges)
        size *= 2;
    int* table = new_array(int, size); // first point + 1 at each position, 0 where empty
    int* first = disjoint_make(source->point_count);
    for (int e = 0; e < edges->count; e++) {
        if (edges->sides[e] != 1)
            continue;
        for (int k = 0; k < 2; k++) {
            const int point = edges->end[e][k];
            size_t slot = position_hash(source->point[point]) & (size - 1);
            while (table[slot] &&
                   !same_position(source->point[table[slot] - 1], source->point[point]))
                slot = (slot + 1) & (size - 1);
            if (!table[slot])
                table[slot] = point + 1;
            first[point] = table[slot] - 1;
        }
    }
    free(table);
    return first;
}

/// Replace every corner by its value in the map.
static Faces map_corners(const MeshSource* source, const int* map) {
    Faces mapped = new_array(int[4], source->face_count);
    for (int f = 0; f < source->face_count; f++)
        for (int k = 0; k < 4; k++)
            mapped[f][k] = source->face[f][k] == NONE ? NONE : map[source->face[f][k]];
    return mapped;
}

/// map[i]: the first of the points that are sewn together with point i.
static int* sew(const MeshSource* source, const Edges* edges, const int* first) {
    Faces merged = map_corners(source, first);
    Edges seams;
    edges_find(&seams, (ConstFaces)merged, source->face_count, source->point_count);

    int* map = disjoint_make(source->point_count);
    ConstFaces face = (ConstFaces)source->face;
    for (int e = 0; e < seams.count; e++) {
        const int s = seams.side[e][0];
        const int t = seams.side[e][1];
        if (seams.sides[e] != 2 || edges->of_side[s] == edges->of_side[t])
            continue;
        const int start = side_start(face, s);
        const int end = side_end(face, s);
        const bool same_way = first[start] == first[side_start(face, t)];
        disjoint_join(map, start, same_way ? side_start(face, t) : side_end(face, t));
        disjoint_join(map, end, same_way ? side_end(face, t) : side_start(face, t));
    }
    for (int i = 0; i < source->point_count; i++)
        map[i] = disjoint_root(map, i);
    edges_free(&seams);
    free(merged);
    return map;
}

/// Replace the corners by the map, unless merged points give an edge a third face.
static int apply_map(MeshSource* source, const int* map, int many_before) {
    Faces sewn = map_corners(source, map);
    Edges edges;
    edges_find(&edges, (ConstFaces)sewn, source->face_count, source->point_count);

    int welded = 0;
    if (edges_of_many_sides(&edges) == many_before) {
        memcpy(source->face, sewn, (size_t)source->face_count * sizeof *sewn);
        for (int i = 0; i < source->point_count; i++)
            welded += map[i] != i;
    }
    edges_free(&edges);
    free(sewn);
    return welded;
}

/// Find rims, sew, replace.
static int weld_once(MeshSource* source) {
    Edges edges;
    edges_find(&edges, (ConstFaces)source->face, source->face_count, source->point_count);
    const int rim_edges = edges_of_one_side(&edges);

    int welded = 0;
    if (rim_edges > 0) {
        int* first = first_at_positions(source, &edges, rim_edges);
        int* map = sew(source, &edges, first);
        welded = apply_map(source, map, edges_of_many_sides(&edges));
        free(first);
        free(map);
    }
    edges_free(&edges);
    return welded;
}

int weld_seams(MeshSource* source) {
    // sewn edges are no rims, so a position may now have exactly two rim edges: repeat
    int welded = 0;
    for (int round = weld_once(source); round > 0; round = weld_once(source))
        welded += round;
    return welded;
}
