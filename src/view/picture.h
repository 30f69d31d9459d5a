/// A picture to be drawn, as plain arrays in world units, single precision, y up. view/ fills it
/// from the world; the renderer reads it and includes no header of the world.
///
///     Picture picture = {0};
///     picture_open(&picture, world);                   // allocates for every display mode
///     picture_update(&picture, world, &camera, mode);  // each frame
///     renderer_draw(renderer, &picture);
///     picture_close(&picture);                         // and picture_open for the next world
///
/// A frame allocates nothing, unless the number of thrown balls exceeds the capacity.
/// Points are in the order of the mesh. All numbers are finite: after a blowup the world keeps its
/// last good state.
#ifndef BALLOON_VIEW_PICTURE_H
#define BALLOON_VIEW_PICTURE_H

#include <stdbool.h>

#include "view/camera.h"

/// How a skin's surface is painted.
typedef enum SkinPaint {
    PAINT_RUBBER, ///< glossy colored rubber, translucent at its outline, lighter where stretched
    PAINT_FIELD,  ///< matt, each point in its own color from `tint`
    PAINT_FAINT,  ///< a pale, translucent shape behind the lines of a display mode
    PAINT_GHOST,  ///< a veil over everything: the skin of a second copy of the scene
    PAINT_COUNT
} SkinPaint;

/// The surface of a balloon or of a thing, which has only PAINT_FIELD and what that needs.
typedef struct PictureSkin {
    int point_count;
    int triangle_count;
    const int (*triangle)[3]; ///< [triangle_count] counter-clockwise from outside
    float (*position)[3];     ///< [point_count]
    float (*normal)[3];       ///< [point_count] of unit length
    float* stretch;   ///< [point_count] length over rest length, 1 at rest; for PAINT_RUBBER
    float* field;     ///< [point_count] values that a display mode draws on a scale of colors
    float* weight;    ///< [point_count] workspace: sum of weights of a mean over elements
    float (*tint)[3]; ///< [point_count] linear color 0…1; for PAINT_FIELD
    float color[3];   ///< linear color of the unstretched rubber
    SkinPaint paint;
    bool two_sided; ///< an open skin: its inside is drawn too
    bool computed;  ///< normals and stretch have been computed
    bool selected;  ///< drawn with a soft glow around its outline
} PictureSkin;

/// A straight line with a width in pixels of a 720-line picture, drawn over or among the skins.
typedef struct PictureLine {
    float from[3];
    float to[3];
    float color[3];
    float width; ///< [px at 720 lines]
} PictureLine;

/// An opaque glossy ball: thrown spheres, and the knots where strings end.
typedef struct PictureBall {
    float center[3];
    float radius;
    float color[3];
} PictureBall;

typedef struct Picture {
    Camera camera;
    long stamp;   ///< changes whenever skins or balls change; 0: unknown
    bool changed; ///< skins or balls have changed since the last stamp
    int skin_count;
    int balloon_count, thing_count; ///< of the world
    PictureSkin* skin; ///< [skin_count] the world's balloons, its things, then the ghost's balloons
    const struct World* ghost; ///< NULL: there is none
    int line_count;
    int line_capacity;
    PictureLine* line; ///< [line_capacity]
    int ball_count;
    int ball_capacity;
    float range[2];    ///< ends of the color scale, in a mode with one
    int ball_reserved; ///< part of ball_capacity for knots and modes; the rest is for thrown balls
    PictureBall* ball; ///< [ball_capacity]
    bool floor;
    float floor_height;
    float scene_center[3]; ///< center of all skins, knots and nearby balls, and of the shadow map
    float scene_radius;    ///< radius of the sphere about it that holds their bounding box
} Picture;

struct World; // world/world.h; the renderer never looks inside
struct Mode;  // view/mode.h

/// Allocate for every line and ball that a display mode can draw of this world. The picture points
/// into the world's meshes: close it before the world.
void picture_open(Picture* picture, const struct World* world);

/// Add the skins of a second world of the same scene, drawn as ghosts.
void picture_ghost(Picture* picture, const struct World* ghost);

/// Fill the picture from the world's present state: balls of the knots, then the world's balls in
/// their order. A skin that has not moved since the last update is not computed again.
void picture_update(Picture* picture, const struct World* world, const Camera* camera,
                    const struct Mode* mode);

void picture_close(Picture* picture);

/// Append a line or a ball. A display mode that adds more than it has declared is a bug.
void picture_line(Picture* picture, const float from[3], const float to[3], const float color[3],
                  float width);
void picture_ball(Picture* picture, const float center[3], float radius, const float color[3]);

#endif
