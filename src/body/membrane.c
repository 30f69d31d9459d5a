#include "body/membrane.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/counting_sort.h"

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

/// What follows the last element are more of it without rubber.
static void make_lanes(Membrane* membrane) {
    membrane->eights = (membrane->count + LANES - 1) / LANES;
    membrane->lane_corner = new_array(uint32_t[3][LANES], membrane->eights);
    membrane->lane_rest = new_array(real[4][LANES], membrane->eights);
    for (int k = 0; k < membrane->eights * LANES; k++) {
        const bool over = k >= membrane->count;
        const int e = over ? membrane->count - 1 : k, eight = k / LANES, lane = k % LANES;
        for (int c = 0; c < 3; c++)
            membrane->lane_corner[eight][c][lane] =
                (uint32_t)((size_t)membrane->corner[e][c] * sizeof(real4));
        for (int r = 0; r < 4; r++)
            membrane->lane_rest[eight][r][lane] = over && r == 3 ? 0 : membrane->rest[e][r];
        if (over) // the array has room up to the next eight
            membrane->first[k] = 1;
    }
}

/// Whether of so many equal parts none but neighbors have a particle in common. Elements are in
/// the order of their first particle, so it is enough to look two parts ahead.
static bool are_apart(const Membrane* membrane, int parts) {
    uint32_t end[2] = {0, 0}; // past the particles of the last two parts
    for (int part = 0; part < parts; part++) {
        uint32_t low = UINT32_MAX, high = 0;
        for (int n = membrane_part(membrane->eights, parts, part);
             n < membrane_part(membrane->eights, parts, part + 1); n++)
            for (int k = 0; k < 3 * LANES; k++) {
                const uint32_t at = membrane->lane_corner[n][k / LANES][k % LANES];
                low = at < low ? at : low;
                high = at >= high ? at + 1 : high;
            }
        if (low < end[part % 2])
            return false;
        end[part % 2] = high > end[part % 2] ? high : end[part % 2];
    }
    return true;
}

static void divide(Membrane* membrane) {
    enum { MIN_EIGHTS = 32 };
    membrane->parts = MEMBRANE_MAX_PARTS;
    while (membrane->parts > 1 && (membrane->eights < membrane->parts * MIN_EIGHTS ||
                                   !are_apart(membrane, membrane->parts)))
        membrane->parts /= 2;
}

/// Faces in the order of their first particle, so that elements find their corners in cache.
static void sort_faces(const Mesh* mesh, int* order) {
    int* key = new_array(int, mesh->face_count);
    int* from = new_array(int, mesh->point_count + 1);
    for (int f = 0; f < mesh->face_count; f++) {
        key[f] = mesh->face[f][0];
        for (int k = 1; k < face_corners(mesh->face[f]); k++)
            key[f] = mesh->face[f][k] < key[f] ? mesh->face[f][k] : key[f];
    }
    counting_sort(key, mesh->face_count, mesh->point_count, from, order);
    free(key);
    free(from);
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
    int* order = new_array(int, mesh->face_count);
    sort_faces(mesh, order);
    for (int f = 0; f < mesh->face_count; f++) {
        const int* face = mesh->face[order[f]];
        const Split* split = split_of(face, x);
        for (int k = 0; k < split->count; k++) {
            int corner[3];
            for (int c = 0; c < 3; c++)
                corner[c] = face[split->corner[k][c]];
            make_element(membrane, corner, split->share, x, thickness);
        }
    }
    free(order);
    make_lanes(membrane);
    divide(membrane);
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
        const double thickness = membrane_thickness(membrane, x, e);
        // an element without area is infinitely thick, and keeps its volume
        const double now = thickness < INFINITY ? membrane_share(membrane, e) * thickness *
                                                      membrane_area(membrane, x, e)
                                                : rest;
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
    free(membrane->lane_corner);
    free(membrane->lane_rest);
    *membrane = (Membrane){0};
}
