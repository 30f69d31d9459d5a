#include "mesh/weld.h"

#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "base/memory.h"
#include "mesh/edges.h"
#include "mesh/sets.h"

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

static bool same_place(double4 a, double4 b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static size_t place_hash(double4 p) {
    // adding zero turns -0 into +0, which is the same place
    const double at[3] = {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
    const uint64_t hash = hash_bytes(HASH_START, at, sizeof at);
    return (size_t)(hash ^ hash >> 32);
}

/// place[i] of a rim point: the first rim point that was met at its position; of others: i itself.
static int* find_places(const MeshSource* source, const Edges* edges, int rim_edges) {
    size_t size = 8;
    while (size < 4 * (size_t)rim_edges)
        size *= 2;
    int* table = new_array(int, size); // point + 1 of each place, 0 where empty
    int* place = sets_make(source->point_count);
    for (int e = 0; e < edges->count; e++) {
        if (edges->sides[e] != 1)
            continue;
        for (int k = 0; k < 2; k++) {
            const int point = edges->end[e][k];
            size_t slot = place_hash(source->point[point]) & (size - 1);
            while (table[slot] && !same_place(source->point[table[slot] - 1], source->point[point]))
                slot = (slot + 1) & (size - 1);
            if (!table[slot])
                table[slot] = point + 1;
            place[point] = table[slot] - 1;
        }
    }
    free(table);
    return place;
}

/// The faces with every corner replaced by what it maps to.
static Faces map_corners(const MeshSource* source, const int* map) {
    Faces mapped = new_array(int[4], source->face_count);
    for (int f = 0; f < source->face_count; f++)
        for (int k = 0; k < 4; k++)
            mapped[f][k] = source->face[f][k] == NONE ? NONE : map[source->face[f][k]];
    return mapped;
}

/// map[i]: the first of the points that point i is sewn to.
static int* sew(const MeshSource* source, const Edges* edges, const int* place) {
    Faces at_place = map_corners(source, place);
    Edges seams;
    edges_find(&seams, (ConstFaces)at_place, source->face_count, source->point_count);

    int* map = sets_make(source->point_count);
    ConstFaces face = (ConstFaces)source->face;
    for (int e = 0; e < seams.count; e++) {
        const int s = seams.side[e][0];
        const int t = seams.side[e][1];
        if (seams.sides[e] != 2 || edges->of_side[s] == edges->of_side[t])
            continue;
        const int start = side_start(face, s);
        const int end = side_end(face, s);
        const bool same_way = place[start] == place[side_start(face, t)];
        sets_join(map, start, same_way ? side_start(face, t) : side_end(face, t));
        sets_join(map, end, same_way ? side_end(face, t) : side_start(face, t));
    }
    for (int i = 0; i < source->point_count; i++)
        map[i] = sets_root(map, i);
    edges_free(&seams);
    free(at_place);
    return map;
}

/// Use the map, unless points that were joined around several corners now close a third face in.
static int take_map(MeshSource* source, const int* map, int many_before) {
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

/// One round of finding rims, sewing and taking the result over.
static int weld_once(MeshSource* source) {
    Edges edges;
    edges_find(&edges, (ConstFaces)source->face, source->face_count, source->point_count);
    const int rim_edges = edges_of_one_side(&edges);

    int welded = 0;
    if (rim_edges > 0) {
        int* place = find_places(source, &edges, rim_edges);
        int* map = sew(source, &edges, place);
        welded = take_map(source, map, edges_of_many_sides(&edges));
        free(place);
        free(map);
    }
    edges_free(&edges);
    return welded;
}

int weld_seams(MeshSource* source) {
    // what is sewn is a rim no longer, so others that lie there may be two alone in the next round
    int welded = 0;
    for (int round = weld_once(source); round > 0; round = weld_once(source))
        welded += round;
    return welded;
}
