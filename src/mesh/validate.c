#include "mesh/validate.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/facet.h"
#include "mesh/counting_sort.h"
#include "mesh/disjoint_sets.h"

/// A face has no area if it is below this share of the longest diagonal squared: its corners lie on
/// a line to within the rounding of the cross product. [1]
static const double AREA_MIN = 1e-12;

enum { LOCATION_BYTES = 512 };

/// "file:line" of a face or a point, or the file alone if lines are unknown.
static const char* location(const MeshSource* source, const long* lines, int i,
                            char text[LOCATION_BYTES]) {
    if (lines)
        snprintf(text, LOCATION_BYTES, "%s:%ld", source->name, lines[i]);
    else
        snprintf(text, LOCATION_BYTES, "%s", source->name);
    return text;
}

static bool corners_meet(const Facet* facet) {
    for (int i = 0; i < facet->corners; i++) {
        for (int j = 0; j < i; j++) {
            const double4 d = facet->corner[i] - facet->corner[j];
            if (d[0] == 0 && d[1] == 0 && d[2] == 0)
                return true;
        }
    }
    return false;
}

static bool has_no_area(const Facet* facet) {
    double longest = 0;
    for (int i = 0; i < facet->corners; i++) {
        for (int j = 0; j < i; j++) {
            const double4 d = facet->corner[i] - facet->corner[j];
            longest = fmax(longest, ddot(d, d));
        }
    }
    return dlength(facet_area(facet)) <= AREA_MIN * longest;
}

void validate_degenerate(const MeshSource* source, MeshReport* report) {
    char text[LOCATION_BYTES];
    for (int f = 0; f < source->face_count; f++) {
        const Facet facet = facet_of(source->point, source->face[f]);
        const bool meet = corners_meet(&facet);
        if (!meet && !has_no_area(&facet))
            continue;
        report->degenerate_faces++;
        fault_set(&report->unusable, location(source, source->face_line, f, text),
                  meet ? "face %d has two corners in one place; merge its vertices or delete it"
                       : "face %d has no area: its corners lie on a line; delete it",
                  f + 1);
    }
}

/// The face's corners plus 1, in ascending order: a triangle's NONE becomes zero and comes first.
static void sort_corners(const int face[4], int sorted[4]) {
    for (int k = 0; k < 4; k++) {
        int at = k;
        for (; at > 0 && sorted[at - 1] > face[k] + 1; at--)
            sorted[at] = sorted[at - 1];
        sorted[at] = face[k] + 1;
    }
}

/// Faces in the order of their sorted corners: a radix sort, so that equal faces are neighbors,
/// and the earlier one comes first.
static int* sort_faces(const int (*corner)[4], int face_count, int point_count) {
    int* order = new_array(int, face_count);
    int* next = new_array(int, face_count);
    int* key = new_array(int, face_count);
    int* item = new_array(int, face_count);
    int* from = new_array(int, point_count + 2);
    for (int f = 0; f < face_count; f++)
        order[f] = f;
    for (int k = 3; k >= 0; k--) {
        for (int i = 0; i < face_count; i++)
            key[i] = corner[order[i]][k];
        counting_sort(key, face_count, point_count + 1, from, item);
        for (int i = 0; i < face_count; i++)
            next[i] = order[item[i]];
        int* swap = order;
        order = next;
        next = swap;
    }
    free(next);
    free(key);
    free(item);
    free(from);
    return order;
}

void validate_duplicate(const MeshSource* source, MeshReport* report) {
    char text[LOCATION_BYTES];
    int(*corner)[4] = new_array(int[4], source->face_count);
    for (int f = 0; f < source->face_count; f++)
        sort_corners(source->face[f], corner[f]);
    int* order = sort_faces((const int(*)[4])corner, source->face_count, source->point_count);

    int first = 0;
    for (int i = 1; i < source->face_count; i++) {
        if (memcmp(corner[order[i]], corner[order[first]], sizeof *corner) != 0) {
            first = i;
            continue;
        }
        report->duplicate_faces++;
        fault_set(&report->unusable, location(source, source->face_line, order[i], text),
                  "face %d has the same corners as face %d; delete one", order[i] + 1,
                  order[first] + 1);
    }
    free(corner);
    free(order);
}

void validate_edges(const MeshSource* source, const Edges* edges, MeshReport* report) {
    char text[LOCATION_BYTES];
    for (int e = 0; e < edges->count; e++) {
        if (edges->sides[e] <= 2)
            continue;
        report->nonmanifold_edges++;
        fault_set(
            &report->unusable, location(source, source->face_line, edges->side[e][0] / 4, text),
            "the edge from vertex %d to vertex %d belongs to %d faces; a skin has at most two "
            "there: delete the inner ones",
            edges->end[e][0] + 1, edges->end[e][1] + 1, edges->sides[e]);
    }
}

/// Sets of the faces around each point: the faces of an edge of two faces are joined at both its
/// ends. A face's corner c at the point is the item 4 * face + c.
static int* join_corners(const MeshSource* source, const Edges* edges) {
    const int(*face)[4] = (const int(*)[4])source->face;
    int* fan = disjoint_make(4 * source->face_count);
    for (int e = 0; e < edges->count; e++) {
        if (edges->sides[e] != 2)
            continue;
        const int s = edges->side[e][0];
        const int t = edges->side[e][1];
        const int s_next = s / 4 * 4 + (s % 4 + 1) % face_corners(face[s / 4]);
        const int t_next = t / 4 * 4 + (t % 4 + 1) % face_corners(face[t / 4]);
        const bool same_way = side_start(face, s) == side_start(face, t);
        disjoint_join(fan, s, same_way ? t : t_next);
        disjoint_join(fan, s_next, same_way ? t_next : t);
    }
    return fan;
}

void validate_points(const MeshSource* source, const Edges* edges, MeshReport* report) {
    char text[LOCATION_BYTES];
    int* fan = join_corners(source, edges);
    int* fans = new_array(int, source->point_count);
    for (int c = 0; c < 4 * source->face_count; c++) {
        const int point = source->face[c / 4][c % 4];
        if (point == NONE || disjoint_root(fan, c) != c)
            continue;
        fans[point]++;
        if (fans[point] != 2)
            continue;
        report->nonmanifold_points++;
        fault_set(&report->unusable, location(source, source->point_line, point, text),
                  "two sheets touch in vertex %d alone; give each its own vertex, or join them by "
                  "an edge",
                  point + 1);
    }
    free(fan);
    free(fans);
}

void validate_one_sided(const MeshSource* source, const int clash[2], MeshReport* report) {
    char text[LOCATION_BYTES];
    if (clash[0] == NONE)
        return;
    fault_set(&report->unusable, location(source, source->face_line, clash[0], text),
              "the surface has only one side, as a Moebius strip has: faces %d and %d cannot both "
              "face outward; cut it there",
              clash[0] + 1, clash[1] + 1);
}
