/// The balloons' surfaces. All triangles of one paint, of all balloons together, are sorted far to
/// near on the CPU and drawn in one call: every layer of see-through rubber is blended in its
/// right place, on concave shapes and where balloons overlap, with each triangle set up only once.
#ifndef BALLOON_DRAW_SKINS_H
#define BALLOON_DRAW_SKINS_H

#include <stdint.h>

#include "base/fault.h"
#include "draw/gl.h"
#include "view/picture.h"

/// A point as shaders/skin.vert takes it.
typedef struct SkinPoint {
    float position[3];
    float normal[3];
    float color[3];
    float stretch;
    float open; ///< 1 on an open skin, whose inside is lit, 0 on a closed one
} SkinPoint;

/// Triangles first … first + count of the index buffer.
typedef struct SkinRange {
    int first, count;
} SkinRange;

typedef struct Skins {
    GLuint program[PAINT_COUNT];
    GLuint array, points, triangles;
    SkinRange painted[PAINT_COUNT]; ///< far to near
    SkinRange selected;

    long stamp;   ///< stamp of the picture that was taken last
    float eye[3]; ///< from where

    int point_capacity, triangle_capacity; ///< what the arrays below have room for
    SkinPoint* point;                      ///< [point_capacity]
    float* distance2;                      ///< [point_capacity] squared distance from the eye
    int (*triangle)[3]; ///< [2 triangle_capacity] painted ones, then the selected again
    int (*gathered)[3]; ///< [triangle_capacity] one paint's, as they come
    float* depth;       ///< [triangle_capacity]
    int* order;         ///< [triangle_capacity]
    uint64_t* scratch;  ///< [2 triangle_capacity]
} Skins;

bool skins_open(Skins* skins, const char* shader_dir, Fault* fault);
/// Gather, sort and hand the picture's skins to the driver: points where any has changed, and their
/// order where that or the eye has.
void skins_upload(Skins* skins, const Picture* picture, const float eye[3]);
void skins_draw(const Skins* skins, SkinPaint paint);
/// Is any of them see-through?
bool skins_veil(const Skins* skins);
/// Only the shape of the selected ones, with the program that is in use.
void skins_draw_selected(const Skins* skins);
void skins_close(Skins* skins);

#endif
