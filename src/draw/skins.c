#include "draw/skins.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "draw/depth.h"
#include "draw/shader.h"

// The fragment shader of each paint.
static const char* const FRAGMENT[PAINT_COUNT] = {
    [PAINT_RUBBER] = "rubber.frag",
    [PAINT_FIELD] = "field.frag",
    [PAINT_FAINT] = "faint.frag",
    [PAINT_GHOST] = "ghost.frag",
};

bool skins_open(Skins* skins, const char* shader_dir, Fault* fault) {
    bool opened = true;
    for (int i = 0; i < PAINT_COUNT; i++) {
        skins->program[i] = shader_load(shader_dir, "skin.vert", FRAGMENT[i], fault);
        opened = opened && skins->program[i];
    }

    glGenVertexArrays(1, &skins->array);
    glGenBuffers(1, &skins->points);
    glGenBuffers(1, &skins->triangles);
    glBindVertexArray(skins->array);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, skins->triangles);
    glBindBuffer(GL_ARRAY_BUFFER, skins->points);
    gl_attribute(0, 3, sizeof(SkinPoint), offsetof(SkinPoint, position));
    gl_attribute(1, 3, sizeof(SkinPoint), offsetof(SkinPoint, normal));
    gl_attribute(2, 3, sizeof(SkinPoint), offsetof(SkinPoint, color));
    gl_attribute(3, 1, sizeof(SkinPoint), offsetof(SkinPoint, stretch));
    gl_attribute(4, 1, sizeof(SkinPoint), offsetof(SkinPoint, open));
    return opened;
}

static void free_arrays(Skins* skins) {
    free(skins->point);
    free(skins->distance2);
    free(skins->triangle);
    free(skins->gathered);
    free(skins->depth);
    free(skins->order);
    free(skins->scratch);
}

// Grow the arrays for a picture larger than all before it.
static void ensure_capacity(Skins* skins, int points, int triangles) {
    if (points <= skins->point_capacity && triangles <= skins->triangle_capacity)
        return;
    free_arrays(skins);
    skins->point_capacity = points > skins->point_capacity ? points : skins->point_capacity;
    skins->triangle_capacity =
        triangles > skins->triangle_capacity ? triangles : skins->triangle_capacity;

    const size_t triple = sizeof skins->triangle[0], capacity = (size_t)skins->triangle_capacity;
    skins->point = new_array(SkinPoint, skins->point_capacity);
    skins->distance2 = new_array(float, skins->point_capacity);
    skins->triangle = memory_array(2 * capacity, triple);
    skins->gathered = memory_array(capacity, triple);
    skins->depth = new_array(float, capacity);
    skins->order = new_array(int, capacity);
    skins->scratch = new_array(uint64_t, 2 * capacity);
}

static void gather_points(Skins* skins, const PictureSkin* skin, int first, const float* eye) {
    for (int i = 0; i < skin->point_count; i++) {
        const float* p = skin->position[i];
        const float* color = skin->paint == PAINT_FIELD ? skin->tint[i] : skin->color;
        SkinPoint* point = &skins->point[first + i];
        memcpy(point->position, p, sizeof point->position);
        memcpy(point->normal, skin->normal[i], sizeof point->normal);
        memcpy(point->color, color, sizeof point->color);
        point->stretch = skin->paint == PAINT_RUBBER ? skin->stretch[i] : 1;
        point->open = skin->two_sided ? 1 : 0;
        skins->distance2[first + i] = (p[0] - eye[0]) * (p[0] - eye[0]) +
                                      (p[1] - eye[1]) * (p[1] - eye[1]) +
                                      (p[2] - eye[2]) * (p[2] - eye[2]);
    }
}

// Whether the triangle's outside faces the eye.
static bool faces_eye(const float* a, const float* b, const float* c, const float* eye) {
    const float u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const float v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    return (eye[0] - a[0]) * (u[1] * v[2] - u[2] * v[1]) +
               (eye[1] - a[1]) * (u[2] * v[0] - u[0] * v[2]) +
               (eye[2] - a[2]) * (u[0] * v[1] - u[1] * v[0]) >
           0;
}

// Append the visible triangles; the far side of a closed skin is visible only through rubber.
static int gather_triangles(Skins* skins, const PictureSkin* skin, int first, int count,
                            const float* eye) {
    const bool both = skin->two_sided || skin->paint == PAINT_RUBBER;
    for (int i = 0; i < skin->triangle_count; i++) {
        const int* t = skin->triangle[i];
        if (!both &&
            !faces_eye(skin->position[t[0]], skin->position[t[1]], skin->position[t[2]], eye))
            continue;
        int* to = skins->gathered[count];
        for (int k = 0; k < 3; k++)
            to[k] = first + t[k];
        skins->depth[count++] =
            skins->distance2[to[0]] + skins->distance2[to[1]] + skins->distance2[to[2]];
    }
    return count;
}

// All triangles of one paint, far to near, appended to the index array at `used`.
static int gather_paint(Skins* skins, const Picture* picture, SkinPaint paint, int used,
                        const float* eye) {
    int first = 0, count = 0;
    for (int i = 0; i < picture->skin_count; i++) {
        const PictureSkin* skin = &picture->skin[i];
        if (skin->paint == paint)
            count = gather_triangles(skins, skin, first, count, eye);
        first += skin->point_count;
    }

    depth_sort(skins->depth, count, skins->order, skins->scratch);
    for (int i = 0; i < count; i++)
        memcpy(skins->triangle[used + i], skins->gathered[skins->order[i]],
               sizeof skins->triangle[0]);
    skins->painted[paint] = (SkinRange){used, count};
    return used + count;
}

static int gather_selected(Skins* skins, const Picture* picture, int used) {
    skins->selected = (SkinRange){used, 0};
    int first = 0;
    for (int i = 0; i < picture->skin_count; i++) {
        const PictureSkin* skin = &picture->skin[i];
        for (int j = 0; skin->selected && j < skin->triangle_count; j++)
            for (int k = 0; k < 3; k++)
                skins->triangle[used + skins->selected.count + j][k] = first + skin->triangle[j][k];
        skins->selected.count += skin->selected ? skin->triangle_count : 0;
        first += skin->point_count;
    }
    return used + skins->selected.count;
}

// glBufferData makes new storage each time: the driver may still be reading the old.
static void upload_points(const Skins* skins, int points) {
    glBindBuffer(GL_ARRAY_BUFFER, skins->points);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)sizeof(SkinPoint) * points, skins->point,
                 GL_STREAM_DRAW);
}

static void upload_triangles(const Skins* skins, int triangles) {
    glBindVertexArray(skins->array);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)sizeof skins->triangle[0] * triangles,
                 skins->triangle, GL_STREAM_DRAW);
}

void skins_upload(Skins* skins, const Picture* picture, const float eye[3]) {
    const bool changed = picture->stamp == 0 || picture->stamp != skins->stamp;
    if (!changed && memcmp(eye, skins->eye, sizeof skins->eye) == 0)
        return;
    skins->stamp = picture->stamp;
    memcpy(skins->eye, eye, sizeof skins->eye);

    int points = 0, triangles = 0;
    for (int i = 0; i < picture->skin_count; i++) {
        points += picture->skin[i].point_count;
        triangles += picture->skin[i].triangle_count;
    }
    ensure_capacity(skins, points, triangles);

    int first = 0;
    for (int i = 0; i < picture->skin_count; i++) {
        gather_points(skins, &picture->skin[i], first, eye);
        first += picture->skin[i].point_count;
    }

    int used = 0;
    for (int paint = 0; paint < PAINT_COUNT; paint++)
        used = gather_paint(skins, picture, (SkinPaint)paint, used, eye);
    used = gather_selected(skins, picture, used);
    if (changed)
        upload_points(skins, points);
    upload_triangles(skins, used);
}

static void draw_range(const Skins* skins, SkinRange range) {
    glBindVertexArray(skins->array);
    glDrawElements(GL_TRIANGLES, 3 * range.count, GL_UNSIGNED_INT,
                   (const void*)(sizeof skins->triangle[0] * (size_t)range.first));
}

void skins_draw(const Skins* skins, SkinPaint paint) {
    if (skins->painted[paint].count == 0)
        return;
    glUseProgram(skins->program[paint]);
    draw_range(skins, skins->painted[paint]);
}

bool skins_have_translucent(const Skins* skins) {
    return skins->painted[PAINT_RUBBER].count > 0 || skins->painted[PAINT_FAINT].count > 0;
}

void skins_draw_selected(const Skins* skins) {
    draw_range(skins, skins->selected);
}

void skins_close(Skins* skins) {
    free_arrays(skins);
    glDeleteBuffers(2, (GLuint[]){skins->points, skins->triangles});
    glDeleteVertexArrays(1, &skins->array);
    for (int i = 0; i < PAINT_COUNT; i++)
        glDeleteProgram(skins->program[i]);
}
