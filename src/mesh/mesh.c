#include "mesh/mesh.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/edges.h"
#include "mesh/counting_sort.h"
#include "mesh/reorder.h"

/// Item 2 e + k is end k of edge e; the neighbor that it stands for is the other end.
static int neighbor_of(const Edges* edges, int item) {
    return edges->end[item / 2][1 - item % 2];
}

/// The neighbor that follows counter-clockwise around a point: in the face to the left of the edge
/// to this one, the corner before the point. NONE on a rim.
static int next_around(const Edges* edges, const int (*face)[4], int item) {
    const int point = edges->end[item / 2][item % 2];
    for (int k = 0; k < 2; k++) {
        const int side = edges->side[item / 2][k];
        if (side == NONE || face[side / 4][side % 4] != point)
            continue;
        const int corners = face_corners(face[side / 4]);
        return face[side / 4][(side % 4 + corners - 1) % corners];
    }
    return NONE;
}

/// Sort a point's neighbors counter-clockwise around it, in time linear in their number.
/// at: [point_count] scratch: the position of each neighbor in the list.
static void sort_around(const Edges* edges, const int (*face)[4], int count, int* item, int* at) {
    for (int k = 0; k < count; k++)
        at[neighbor_of(edges, item[k])] = k;
    for (int i = 1; i < count; i++) {
        const int next = next_around(edges, face, item[i - 1]);
        const int k = next == NONE ? 0 : at[next];
        if (k < i)
            continue; // a rim, or a full circle: what remains keeps its order
        const int swap = item[i];
        item[i] = item[k];
        item[k] = swap;
        at[neighbor_of(edges, swap)] = k;
        at[next] = i;
    }
}

/// loaded and inside: the points reordered (mesh/reorder.h), and the inverse.
static void number_points(Mesh* mesh, const Edges* edges, const int (*face)[4]) {
    const int points = mesh->point_count;
    const int ends = 2 * edges->count;
    int* from = new_array(int, points + 1);
    int* neighbor = new_array(int, ends);
    int* at = new_array(int, points);

    counting_sort(edges->end[0], ends, points, from, neighbor);
    for (int p = 0; p < points; p++)
        sort_around(edges, face, from[p + 1] - from[p], &neighbor[from[p]], at);
    free(at);
    for (int i = 0; i < ends; i++)
        neighbor[i] = neighbor_of(edges, neighbor[i]);

    mesh->loaded = new_array(int, points);
    mesh->inside = new_array(int, points);
    reorder_points(points, from, neighbor, mesh->loaded);
    for (int i = 0; i < points; i++)
        mesh->inside[mesh->loaded[i]] = i;
    free(from);
    free(neighbor);
}

static void copy_points(Mesh* mesh, const double4* point) {
    mesh->point = new_array(double4, mesh->point_count);
    for (int i = 0; i < mesh->point_count; i++)
        mesh->point[i] = point[mesh->loaded[i]];
}

static void copy_faces(Mesh* mesh, const int (*face)[4]) {
    mesh->face = new_array(int[4], mesh->face_count);
    for (int f = 0; f < mesh->face_count; f++)
        for (int k = 0; k < 4; k++)
            mesh->face[f][k] = face[f][k] == NONE ? NONE : mesh->inside[face[f][k]];
}

static void copy_edges(Mesh* mesh, const Edges* edges) {
    mesh->edge_count = edges->count;
    mesh->edge = new_array(int[2], edges->count);
    mesh->edge_face = new_array(int[2], edges->count);
    mesh->closed = true;
    for (int e = 0; e < edges->count; e++) {
        ASSERT(edges->sides[e] <= 2, "the doctor lets no edge of three faces through");
        for (int k = 0; k < 2; k++) {
            const int side = edges->side[e][k];
            mesh->edge[e][k] = mesh->inside[edges->end[e][k]];
            mesh->edge_face[e][k] = side == NONE ? NONE : side / 4;
        }
        mesh->closed = mesh->closed && edges->sides[e] == 2;
    }
}

/// The faces and the edges around each point.
static void find_adjacency(Mesh* mesh) {
    const int corners = 4 * mesh->face_count;
    mesh->point_face_from = new_array(int, mesh->point_count + 1);
    mesh->point_face = new_array(int, corners);
    counting_sort(mesh->face[0], corners, mesh->point_count, mesh->point_face_from,
                  mesh->point_face);
    for (int i = 0; i < mesh->point_face_from[mesh->point_count]; i++)
        mesh->point_face[i] /= 4;

    const int ends = 2 * mesh->edge_count;
    mesh->point_edge_from = new_array(int, mesh->point_count + 1);
    mesh->point_edge = new_array(int, ends);
    counting_sort(mesh->edge[0], ends, mesh->point_count, mesh->point_edge_from, mesh->point_edge);
    for (int i = 0; i < ends; i++)
        mesh->point_edge[i] /= 2;
}

static double distance_squared(const Mesh* mesh, int a, int b) {
    const double4 d = mesh->point[b] - mesh->point[a];
    return ddot(d, d);
}

/// Quads are split along their shorter diagonal, which keeps the triangles fat.
static void split_faces(Mesh* mesh) {
    mesh->triangle = new_array(int[3], 2 * (size_t)mesh->face_count);
    for (int f = 0; f < mesh->face_count; f++) {
        const int* c = mesh->face[f];
        const bool quad = c[3] != NONE;
        const bool along_bd =
            quad && distance_squared(mesh, c[1], c[3]) < distance_squared(mesh, c[0], c[2]);
        const int split[2][3] = {
            {c[0], c[1], along_bd ? c[3] : c[2]},
            {along_bd ? c[1] : c[0], c[2], c[3]},
        };
        for (int t = 0; t < 1 + quad; t++)
            memcpy(mesh->triangle[mesh->triangle_count++], split[t], sizeof split[t]);
    }
}

void mesh_make(Mesh* mesh, const double4* point, int point_count, const int (*face)[4],
               int face_count) {
    *mesh = (Mesh){.point_count = point_count, .face_count = face_count};
    Edges edges;
    edges_find(&edges, face, face_count, point_count);

    number_points(mesh, &edges, face);
    copy_points(mesh, point);
    copy_faces(mesh, face);
    copy_edges(mesh, &edges);
    find_adjacency(mesh);
    split_faces(mesh);
    edges_free(&edges);
}

void mesh_free(Mesh* mesh) {
    free(mesh->point);
    free(mesh->face);
    free(mesh->edge);
    free(mesh->edge_face);
    free(mesh->triangle);
    free(mesh->point_face_from);
    free(mesh->point_face);
    free(mesh->point_edge_from);
    free(mesh->point_edge);
    free(mesh->loaded);
    free(mesh->inside);
    *mesh = (Mesh){0};
}
