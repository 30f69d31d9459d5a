#include "body/springs.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/memory.h"

const char* const spring_kind_name[SPRING_KINDS] = {"structural", "shear", "flexion"};
const char* const spring_law_name[SPRING_LAWS] = {"hooke", "rubber", "tension"};

/// Pairs as they are found. Their number follows from valences and coincidences; to count them first
/// would cost as much as to find them.
typedef struct Pairs {
    int count;
    int capacity;
    int (*end)[2];
} Pairs;

static void push(Pairs* pairs, int a, int b) {
    array_reserve(pairs->end, pairs->count, pairs->capacity);
    pairs->end[pairs->count][0] = a;
    pairs->end[pairs->count][1] = b;
    pairs->count++;
}

/// The corner across a quad's diagonal from point p, NONE in a triangle.
static int opposite(const int face[4], int p) {
    if (face[3] == NONE)
        return NONE;
    for (int c = 0; c < 4; c++)
        if (face[c] == p)
            return face[(c + 2) % 4];
    return NONE;
}

static void find_structural(const Mesh* mesh, Pairs* pairs) {
    for (int e = 0; e < mesh->edge_count; e++)
        push(pairs, mesh->edge[e][0], mesh->edge[e][1]);
}

/// seen[q] == p: the pair (p, q) is taken, by an edge or by another quad with the same diagonal.
static void find_shear(const Mesh* mesh, int* seen, Pairs* pairs) {
    for (int p = 0; p < mesh->point_count; p++) {
        for (int k = mesh->point_edge_from[p]; k < mesh->point_edge_from[p + 1]; k++)
            seen[mesh_across(mesh, mesh->point_edge[k], p)] = p;

        for (int k = mesh->point_face_from[p]; k < mesh->point_face_from[p + 1]; k++) {
            const int q = opposite(mesh->face[mesh->point_face[k]], p);
            if (q == NONE || seen[q] == p)
                continue;
            seen[q] = p;
            if (p < q)
                push(pairs, p, q);
        }
    }
}

/// seen[q] == p: p and q share a face, or the pair is found already.
static void find_flexion(const Mesh* mesh, int* seen, Pairs* pairs) {
    for (int p = 0; p < mesh->point_count; p++) {
        seen[p] = p;
        for (int k = mesh->point_face_from[p]; k < mesh->point_face_from[p + 1]; k++) {
            const int* face = mesh->face[mesh->point_face[k]];
            for (int c = 0; c < face_corners(face); c++)
                seen[face[c]] = p;
        }

        for (int k = mesh->point_edge_from[p]; k < mesh->point_edge_from[p + 1]; k++) {
            const int m = mesh_across(mesh, mesh->point_edge[k], p);
            for (int j = mesh->point_edge_from[m]; j < mesh->point_edge_from[m + 1]; j++) {
                const int q = mesh_across(mesh, mesh->point_edge[j], m);
                if (seen[q] == p)
                    continue;
                seen[q] = p;
                if (p < q)
                    push(pairs, p, q);
            }
        }
    }
}

double springs_paths(const Mesh* mesh, int* vertex) {
    double paths = 0, most = 0;
    for (int i = 0; i < mesh->point_count; i++) {
        const double valence = mesh->point_edge_from[i + 1] - mesh->point_edge_from[i];
        paths += valence * (valence - 1) / 2;
        if (valence > most) {
            most = valence;
            *vertex = i;
        }
    }
    return paths;
}

static void forget(int* seen, int count) {
    for (int i = 0; i < count; i++)
        seen[i] = NONE;
}

void springs_find(const Mesh* mesh, const bool wanted[SPRING_KINDS], Springs* springs) {
    Pairs pairs = {0};
    int* seen = new_array(int, mesh->point_count);

    if (wanted[STRUCTURAL])
        find_structural(mesh, &pairs);
    springs->from[SHEAR] = pairs.count;

    forget(seen, mesh->point_count);
    if (wanted[SHEAR])
        find_shear(mesh, seen, &pairs);
    springs->from[FLEXION] = pairs.count;

    forget(seen, mesh->point_count);
    if (wanted[FLEXION])
        find_flexion(mesh, seen, &pairs);
    springs->from[SPRING_KINDS] = pairs.count;

    springs->count = pairs.count;
    springs->end = pairs.end;
    free(seen);
}

void springs_free(Springs* springs) {
    free(springs->end);
    free(springs->stiffness);
    free(springs->rest);
    free(springs->active);
    *springs = (Springs){0};
}
