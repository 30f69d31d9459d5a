#include "view/thing_surface.h"

#include <stdlib.h>

#include "base/memory.h"
#include "mesh/point_corners.h"
#include "view/color.h"

static const double crease = 0.766;                 ///< [1] cosine of 40 degrees
static const float gray[3] = {0.62f, 0.60f, 0.57f}; ///< sRGB

static double4 area_vector(const Thing* thing, int t) {
    const int* corner = thing->mesh.triangle[t];
    const double4 a = to_double4(thing->body.x[corner[0]]);
    return dcross(to_double4(thing->body.x[corner[1]]) - a,
                  to_double4(thing->body.x[corner[2]]) - a);
}

static void set_normal(float normal[3], double4 sum) {
    const double size = dlength(sum);
    for (int k = 0; k < 3; k++)
        normal[k] = size > 0 ? (float)(sum[k] / size) : k == 1;
}

static void set_normals(PictureSkin* skin, const Thing* thing) {
    const Mesh* mesh = &thing->mesh;
    const int corners = 3 * mesh->triangle_count;
    PointCorners around = point_corners_open(mesh);
    for (int c = 0; c < corners; c++) {
        const double4 own = area_vector(thing, c / 3);
        const int point = mesh->triangle[c / 3][c % 3];
        double4 sum = {0};
        for (int k = around.from[point]; k < around.from[point + 1]; k++) {
            const double4 other = area_vector(thing, around.corner[k] / 3);
            if (ddot(own, other) >= crease * dlength(own) * dlength(other))
                sum += other;
        }
        set_normal(skin->normal[c], sum);
    }
    point_corners_close(&around);
}

void thing_surface_open(PictureSkin* skin, const Thing* thing, const double* color) {
    const Mesh* mesh = &thing->mesh;
    const int corners = 3 * mesh->triangle_count;
    int(*triangle)[3] = new_array(int[3], mesh->triangle_count);
    *skin = (PictureSkin){
        .point_count = corners,
        .triangle_count = mesh->triangle_count,
        .triangle = (const int(*)[3])triangle,
        .position = new_array(float[3], corners),
        .normal = new_array(float[3], corners),
        .tint = new_array(float[3], corners),
        .paint = PAINT_FIELD,
        .two_sided = !mesh->closed,
    };
    float shown[3];
    for (int k = 0; k < 3; k++)
        shown[k] = color ? (float)color[k] : gray[k];
    color_linear(shown, skin->color);
    for (int c = 0; c < corners; c++)
        for (int k = 0; k < 3; k++)
            skin->tint[c][k] = skin->color[k];
    for (int c = 0; c < corners; c++)
        triangle[c / 3][c % 3] = c;
    set_normals(skin, thing);
}

bool thing_surface_update(PictureSkin* skin, const Thing* thing) {
    bool moved = false;
    for (int c = 0; c < skin->point_count; c++)
        for (int k = 0; k < 3; k++) {
            const float now = (float)thing->body.x[thing->mesh.triangle[c / 3][c % 3]][k];
            moved |= skin->position[c][k] != now;
            skin->position[c][k] = now;
        }
    if (moved && thing->spin_max > 0)
        set_normals(skin, thing);
    return moved;
}

void thing_surface_close(PictureSkin* skin) {
    free((void*)(uintptr_t)skin->triangle);
    free(skin->position);
    free(skin->normal);
    free(skin->tint);
    *skin = (PictureSkin){0};
}
