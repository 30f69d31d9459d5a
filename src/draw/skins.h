/// The balloons' surfaces. For each paint, the triangles of all balloons are sorted from far to near
/// on the CPU and drawn in one call, so that layers of translucent rubber are blended in the right
/// order, on concave shapes and where balloons overlap.
#ifndef BALLOON_DRAW_SKINS_H
#define BALLOON_DRAW_SKINS_H

#include <stdint.h>

#include "base/fault.h"
#include "draw/gl.h"
#include "view/picture.h"

/// A vertex of shaders/skin.vert.
typedef struct SkinPoint {
    float position[3];
    float normal[3];
    float color[3];
    float stretch;
    float open; ///< 1 on an open skin, whose inside is lit; 0 on a closed one
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

    long stamp;   ///< stamp of the last picture that was uploaded
    float eye[3]; ///< its eye

    int point_capacity, triangle_capacity; ///< lengths of the arrays below
    SkinPoint* point;                      ///< [point_capacity]
    float* distance2;                      ///< [point_capacity] squared distance from the eye
    int (*triangle)[3]; ///< [2 triangle_capacity] by paint, then those of selected skins again
    int (*gathered)[3]; ///< [triangle_capacity] those of one paint, unsorted
    float* depth;       ///< [triangle_capacity]
    int* order;         ///< [triangle_capacity]
    uint64_t* scratch;  ///< [2 triangle_capacity]
} Skins;

bool skins_open(Skins* skins, const char* shader_dir, Fault* fault);
/// Gather, sort and upload the picture's skins: points if the picture has changed, the order of
/// triangles if the picture or the eye has.
void skins_upload(Skins* skins, const Picture* picture, const float eye[3]);
void skins_draw(const Skins* skins, SkinPaint paint);
/// Whether any skin is translucent.
bool skins_have_translucent(const Skins* skins);
/// Draw the selected skins with the program that is in use.
void skins_draw_selected(const Skins* skins);
void skins_close(Skins* skins);

#endif
