#include "mesh/moment.h"

/// The triangles that a face is split into, and the weight of each.
typedef struct Parts {
    int count;
    real share;
} Parts;

static const int part_corner[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};

static Parts parts_of(const int face[4]) {
    return face_corners(face) == 3 ? (Parts){1, 1} : (Parts){4, (real)0.5};
}

/// Corners of a part, heights from the level.
static void load_corners(const int face[4], int part, const real4* x, real level, real4 at[3]) {
    for (int c = 0; c < 3; c++) {
        at[c] = x[face[part_corner[part][c]]];
        at[c][1] -= level;
    }
}

/// N_y, and its gradient at corner c: (z of the last corner - z of the next, 0, x of next - of
/// last).
static real normal_y(const real4 at[3]) {
    return (at[1][2] - at[0][2]) * (at[2][0] - at[0][0]) -
           (at[1][0] - at[0][0]) * (at[2][2] - at[0][2]);
}

static real4 normal_y_gradient(const real4 at[3], int c) {
    const real4 next = at[(c + 1) % 3], last = at[(c + 2) % 3];
    return (real4){last[2] - next[2], 0, next[0] - last[0], 0};
}

/// Q, the sum of products of heights, and its derivative by the height of corner c.
static real height_sum(const real4 at[3]) {
    const real a = at[0][1], b = at[1][1], c = at[2][1];
    return a * a + b * b + c * c + a * b + b * c + c * a;
}

static real height_sum_slope(const real4 at[3], int c) {
    return at[0][1] + at[1][1] + at[2][1] + at[c][1];
}

double moment_of_height(const Mesh* mesh, const real4* x, double level) {
    double sum = 0;
    for (int f = 0; f < mesh->face_count; f++) {
        const Parts parts = parts_of(mesh->face[f]);
        for (int p = 0; p < parts.count; p++) {
            real4 at[3];
            load_corners(mesh->face[f], p, x, (real)level, at);
            sum += (double)parts.share * (double)normal_y(at) * (double)height_sum(at);
        }
    }
    return sum / 24;
}

void moment_add_gradient(const Mesh* mesh, const real4* x, double level, real factor, real4* out) {
    for (int f = 0; f < mesh->face_count; f++) {
        const Parts parts = parts_of(mesh->face[f]);
        for (int p = 0; p < parts.count; p++) {
            real4 at[3];
            load_corners(mesh->face[f], p, x, (real)level, at);
            const real k = factor * parts.share / 24, n = normal_y(at), q = height_sum(at);
            for (int c = 0; c < 3; c++) {
                real4 slope = q * normal_y_gradient(at, c);
                slope[1] = n * height_sum_slope(at, c);
                out[mesh->face[f][part_corner[p][c]]] += k * slope;
            }
        }
    }
}

double moment_add_product(const Mesh* mesh, const real4* x, double level, const real4* d,
                          real factor, real4* out) {
    double along = 0;
    for (int f = 0; f < mesh->face_count; f++) {
        const Parts parts = parts_of(mesh->face[f]);
        for (int p = 0; p < parts.count; p++) {
            real4 at[3], by[3];
            load_corners(mesh->face[f], p, x, (real)level, at);
            load_corners(mesh->face[f], p, d, 0, by);
            const real k = factor * parts.share / 24, n = normal_y(at), q = height_sum(at);
            real dn = 0, dq = 0;
            for (int c = 0; c < 3; c++) {
                dn += dot(normal_y_gradient(at, c), by[c]);
                dq += height_sum_slope(at, c) * by[c][1];
            }
            along += (double)parts.share / 24 * ((double)dn * (double)q + (double)n * (double)dq);
            for (int c = 0; c < 3; c++) { // both gradients are linear in x
                real4 change = dq * normal_y_gradient(at, c) + q * normal_y_gradient(by, c);
                change[1] = dn * height_sum_slope(at, c) + n * height_sum_slope(by, c);
                out[mesh->face[f][part_corner[p][c]]] += k * change;
            }
        }
    }
    return along;
}
