#include "mesh/moment.h"

/// The triangles that a face stands for, and the share of each.
typedef struct Parts {
    int count;
    real share;
} Parts;

static const int part_corner[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};

static Parts parts_of(const int face[4]) {
    return face_corners(face) == 3 ? (Parts){1, 1} : (Parts){4, (real)0.5};
}

/// Corners of a part, heights from the level.
static void take(const int face[4], int part, const real4* x, real level, real4 at[3]) {
    for (int c = 0; c < 3; c++) {
        at[c] = x[face[part_corner[part][c]]];
        at[c][1] -= level;
    }
}

/// N_y, and its derivative by each corner: (z of next but one - z of next, 0, …).
static real upward(const real4 at[3]) {
    return (at[1][2] - at[0][2]) * (at[2][0] - at[0][0]) -
           (at[1][0] - at[0][0]) * (at[2][2] - at[0][2]);
}

static real4 upward_slope(const real4 at[3], int c) {
    const real4 next = at[(c + 1) % 3], last = at[(c + 2) % 3];
    return (real4){last[2] - next[2], 0, next[0] - last[0], 0};
}

/// Q, and its derivative by a corner's height.
static real square(const real4 at[3]) {
    const real a = at[0][1], b = at[1][1], c = at[2][1];
    return a * a + b * b + c * c + a * b + b * c + c * a;
}

static real square_slope(const real4 at[3], int c) {
    return at[0][1] + at[1][1] + at[2][1] + at[c][1];
}

double moment_of_height(const Mesh* mesh, const real4* x, double level) {
    double sum = 0;
    for (int f = 0; f < mesh->face_count; f++) {
        const Parts parts = parts_of(mesh->face[f]);
        for (int p = 0; p < parts.count; p++) {
            real4 at[3];
            take(mesh->face[f], p, x, (real)level, at);
            sum += (double)parts.share * (double)upward(at) * (double)square(at);
        }
    }
    return sum / 24;
}

void moment_add_gradient(const Mesh* mesh, const real4* x, double level, real factor, real4* out) {
    for (int f = 0; f < mesh->face_count; f++) {
        const Parts parts = parts_of(mesh->face[f]);
        for (int p = 0; p < parts.count; p++) {
            real4 at[3];
            take(mesh->face[f], p, x, (real)level, at);
            const real k = factor * parts.share / 24, n = upward(at), q = square(at);
            for (int c = 0; c < 3; c++) {
                real4 slope = q * upward_slope(at, c);
                slope[1] = n * square_slope(at, c);
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
            take(mesh->face[f], p, x, (real)level, at);
            take(mesh->face[f], p, d, 0, by);
            const real k = factor * parts.share / 24, n = upward(at), q = square(at);
            real dn = 0, dq = 0;
            for (int c = 0; c < 3; c++) {
                dn += dot(upward_slope(at, c), by[c]);
                dq += square_slope(at, c) * by[c][1];
            }
            along += (double)parts.share / 24 * ((double)dn * (double)q + (double)n * (double)dq);
            for (int c = 0; c < 3; c++) { // both slopes are linear, so their change is that of d
                real4 change = dq * upward_slope(at, c) + q * upward_slope(by, c);
                change[1] = dn * square_slope(at, c) + n * square_slope(by, c);
                out[mesh->face[f][part_corner[p][c]]] += k * change;
            }
        }
    }
    return along;
}
