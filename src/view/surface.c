#include "view/surface.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "view/color.h"
#include "view/field.h"

void surface_open(PictureSkin* skin, const Balloon* balloon) {
    const Mesh* mesh = &balloon->mesh;
    *skin = (PictureSkin){
        .point_count = mesh->point_count,
        .triangle_count = mesh->triangle_count,
        .triangle = (const int(*)[3])mesh->triangle,
        .position = new_array(float[3], mesh->point_count),
        .normal = new_array(float[3], mesh->point_count),
        .stretch = new_array(float, mesh->point_count),
        .field = new_array(float, mesh->point_count),
        .weight = new_array(float, mesh->point_count),
        .tint = new_array(float[3], mesh->point_count),
        .two_sided = !mesh->closed,
    };
    color_linear(balloon->color, skin->color);
}

static double rest_length(const Mesh* mesh, int edge) {
    return dlength(mesh->point[mesh->edge[edge][0]] - mesh->point[mesh->edge[edge][1]]);
}

float surface_edge_length(const Balloon* balloon) {
    const Mesh* mesh = &balloon->mesh;
    double sum = 0;
    for (int e = 0; e < mesh->edge_count; e++)
        sum += rest_length(mesh, e);
    return (float)(balloon->body.scale * sum / mesh->edge_count);
}

/// Copy the positions; returns whether any has changed.
static bool positions(PictureSkin* skin, const real4* x) {
    bool moved = false;
    for (int i = 0; i < skin->point_count; i++)
        for (int k = 0; k < 3; k++) {
            const float now = (float)x[i][k];
            moved |= skin->position[i][k] != now;
            skin->position[i][k] = now;
        }
    return moved;
}

/// Twice a face's area vector: the cross product of its diagonals, or of two edges.
static double4 area_vector(const int face[4], const real4* x) {
    const double4 a = to_double4(x[face[0]]), b = to_double4(x[face[1]]);
    const double4 c = to_double4(x[face[2]]);
    if (face[3] == NONE)
        return dcross(b - a, c - a);
    return dcross(c - a, to_double4(x[face[3]]) - b);
}

static void normals(PictureSkin* skin, const Mesh* mesh, const Body* body) {
    memset(skin->normal, 0, (size_t)skin->point_count * sizeof *skin->normal);

    // in units of the body's size, so that the sums neither underflow nor overflow single precision
    const double unit = 1 / (body->size * body->size);
    for (int f = 0; f < mesh->face_count; f++) {
        const int* face = mesh->face[f];
        const double4 vector = unit * area_vector(face, body->x);
        for (int c = 0; c < face_corners(face); c++)
            for (int k = 0; k < 3; k++)
                skin->normal[face[c]][k] += (float)vector[k];
    }

    for (int i = 0; i < skin->point_count; i++) {
        float* n = skin->normal[i];
        const float size = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (size > 0)
            for (int k = 0; k < 3; k++)
                n[k] /= size;
        else
            n[1] = 1; // all faces of the point have area 0: any direction will do
    }
}

static FieldShare element_stretch(const Membrane* membrane, const real4* x, int e) {
    const double share = membrane_share(membrane, e);
    return (FieldShare){share * membrane_stretch(membrane, x, e), share};
}

static void edge_stretches(PictureSkin* skin, const Mesh* mesh, const Body* body) {
    memset(skin->stretch, 0, (size_t)skin->point_count * sizeof *skin->stretch);
    for (int e = 0; e < mesh->edge_count; e++) {
        const int a = mesh->edge[e][0], b = mesh->edge[e][1];
        const double now = dlength(to_double4(body->x[a]) - to_double4(body->x[b]));
        const float ratio = (float)(now / (body->scale * rest_length(mesh, e)));
        skin->stretch[a] += ratio;
        skin->stretch[b] += ratio;
    }
    for (int i = 0; i < skin->point_count; i++) {
        const int valence = mesh->point_edge_from[i + 1] - mesh->point_edge_from[i];
        skin->stretch[i] /= (float)valence;
    }
}

bool surface_update(PictureSkin* skin, const Balloon* balloon) {
    const bool moved = positions(skin, balloon->body.x);
    if (!moved && skin->computed)
        return false;
    skin->computed = true;
    normals(skin, &balloon->mesh, &balloon->body);
    if (balloon->body.membrane.count > 0)
        field_of_elements(skin, &balloon->body, element_stretch, skin->stretch);
    else
        edge_stretches(skin, &balloon->mesh, &balloon->body);
    return true;
}

void surface_close(PictureSkin* skin) {
    free(skin->position);
    free(skin->normal);
    free(skin->stretch);
    free(skin->field);
    free(skin->weight);
    free(skin->tint);
    *skin = (PictureSkin){0};
}
