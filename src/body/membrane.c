#include "body/membrane.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

const char* const volume_rule_name[VOLUME_RULES] = {"local", "global"};

/// Diagonals within this ratio are alike: far above float's rounding, far below what a mesh means.
static const double alike = 1e-5;

/// The triangles into which a face is split, as corners of the face.
typedef struct Split {
    int count;
    int corner[4][3];
    double share; ///< of each in the skin
} Split;

static const Split whole = {1, {{0, 1, 2}}, 1};
static const Split along_ac = {2, {{0, 1, 2}, {0, 2, 3}}, 1};
static const Split along_bd = {2, {{0, 1, 3}, {1, 2, 3}}, 1};
static const Split along_both = {4, {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}, 0.5};

static const Split* split_of(const int face[4], const real4* x) {
    if (face_corners(face) == 3)
        return &whole;
    const double ac = dlength(to_double4(x[face[2]]) - to_double4(x[face[0]]));
    const double bd = dlength(to_double4(x[face[3]]) - to_double4(x[face[1]]));
    if (fabs(ac - bd) <= alike * ac)
        return &along_both;
    return ac < bd ? &along_ac : &along_bd;
}

static void make_element(Membrane* membrane, const int corner[3], double share, const real4* x,
                         const double* thickness) {
    const int e = membrane->count++;
    memcpy(membrane->corner[e], corner, sizeof membrane->corner[e]);

    const double4 a = to_double4(x[corner[0]]);
    const double4 e1 = to_double4(x[corner[1]]) - a, e2 = to_double4(x[corner[2]]) - a;
    const double l = dlength(e1), along = ddot(e1, e2) / l, area = dlength(dcross(e1, e2)) / 2;
    const double up = 2 * area / l;
    const double h = (thickness[corner[0]] + thickness[corner[1]] + thickness[corner[2]]) / 3;

    membrane->rest[e] =
        (real4){(real)(1 / l), (real)(-along / (l * up)), (real)(1 / up), (real)(share * h * area)};
    membrane->first[e] = membrane->thickness[e] = (real)h;
    membrane->volume += share * h * area;
}

void membrane_make(Membrane* membrane, const Mesh* mesh, const real4* x, const double* thickness,
                   const Rubber* rubber) {
    int count = 0;
    for (int f = 0; f < mesh->face_count; f++)
        count += split_of(mesh->face[f], x)->count;
    *membrane = (Membrane){
        .rubber = *rubber,
        .corner = new_array(int[3], count),
        .rest = new_array(real4, count),
        .first = new_array(real, count),
        .thickness = new_array(real, count),
    };
    for (int f = 0; f < mesh->face_count; f++) {
        const Split* split = split_of(mesh->face[f], x);
        for (int k = 0; k < split->count; k++) {
            int corner[3];
            for (int c = 0; c < 3; c++)
                corner[c] = mesh->face[f][split->corner[k][c]];
            make_element(membrane, corner, split->share, x, thickness);
        }
    }
}

void membrane_add_mass(const Membrane* membrane, double* mass) {
    for (int e = 0; e < membrane->count; e++)
        for (int k = 0; k < 3; k++)
            mass[membrane->corner[e][k]] +=
                membrane->rubber.density * (double)membrane->rest[e][3] / 3;
}

double membrane_share(const Membrane* membrane, int element) {
    const real4 r = membrane->rest[element];
    const double area = 0.5 / ((double)r[0] * (double)r[2]);
    return (double)r[3] / ((double)membrane->first[element] * area);
}

double membrane_stretch(const Membrane* membrane, const real4* x, int element) {
    const int* c = membrane->corner[element];
    const double4 a = to_double4(x[c[0]]), rest = to_double4(membrane->rest[element]);
    const double4 e1 = to_double4(x[c[1]]) - a, e2 = to_double4(x[c[2]]) - a;
    const double4 f1 = rest[0] * e1, f2 = rest[1] * e1 + rest[2] * e2;
    const double half = (ddot(f1, f1) - ddot(f2, f2)) / 2, across = ddot(f1, f2);
    return sqrt((ddot(f1, f1) + ddot(f2, f2)) / 2 + sqrt(half * half + across * across));
}

VolumeRatio membrane_volume_ratio(const Membrane* membrane, const real4* x) {
    VolumeRatio ratio = {0, 1};
    for (int e = 0; e < membrane->count; e++) {
        const double rest = (double)membrane->rest[e][3];
        const double now = membrane_share(membrane, e) * membrane_thickness(membrane, x, e) *
                           membrane_area(membrane, x, e);
        ratio.sum += now;
        if (fabs(now / rest - 1) > fabs(ratio.worst - 1))
            ratio.worst = now / rest;
    }
    ratio.sum /= membrane->volume;
    return ratio;
}

void membrane_free(Membrane* membrane) {
    free(membrane->corner);
    free(membrane->rest);
    free(membrane->first);
    free(membrane->thickness);
    *membrane = (Membrane){0};
}
