/// What is to be drawn, as plain arrays: the world fills it, the renderer reads it, and neither
/// knows the other. All in world units, single precision, y up.
///
///     Picture picture = {0};
///     picture_open(&picture, world);                    // room for all that a world can show
///     picture_update(&picture, world, &camera, mode);     // each frame
///     renderer_draw(renderer, &picture);
///     picture_close(&picture);                          // and picture_open for the next world
///
/// A frame allocates nothing, unless more balls were thrown than there is room for.
/// Points are in the order of the mesh. Nothing here is ever NaN: a world whose state goes bad
/// keeps its last good one.
#ifndef BALLOON_VIEW_PICTURE_H
#define BALLOON_VIEW_PICTURE_H

#include <stdbool.h>

#include "view/camera.h"

/// How a skin's surface is painted.
typedef enum SkinPaint {
    PAINT_RUBBER, ///< glossy coloured rubber, see-through at the rim, lighter where stretched
    PAINT_FIELD,  ///< matt, each point in its own colour from `tint`
    PAINT_FAINT,  ///< a pale, see-through shape behind lines that are the subject
    PAINT_GHOST,  ///< a veil over everything: the skin of a second copy of the scene
    PAINT_COUNT
} SkinPaint;

/// One balloon's surface.
typedef struct PictureSkin {
    int point_count;
    int triangle_count;
    const int (*triangle)[3]; ///< [triangle_count] counter-clockwise from outside
    float (*position)[3];     ///< [point_count]
    float (*normal)[3];       ///< [point_count] of unit length
    float* stretch;   ///< [point_count] length over rest length, 1 at rest; for PAINT_RUBBER
    float* field;     ///< [point_count] what a display mode shows on a scale of colours
    float* weight;    ///< [point_count] room for means over what meets at a point
    float (*tint)[3]; ///< [point_count] linear colour 0…1; for PAINT_FIELD
    float color[3];   ///< linear colour of the unstretched rubber
    SkinPaint paint;
    bool two_sided; ///< an open skin: its inside is drawn too
    bool computed;  ///< normals and stretch are those of the positions
    bool selected;  ///< drawn with a soft outline glow
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
    long stamp;   ///< of skins and balls: while it stays the same so do they; 0: unknown
    bool changed; ///< against the last stamp
    int skin_count;
    PictureSkin* skin;         ///< [skin_count] the world's, then the ghost's
    const struct World* ghost; ///< NULL: there is none
    int line_count;
    int line_capacity;
    PictureLine* line; ///< [line_capacity]
    int ball_count;
    int ball_capacity;
    float range[2];    ///< ends of the colours' scale in a mode that has one
    int ball_reserved; ///< of the room: for knots and display modes; the world's balls have the rest
    PictureBall* ball; ///< [ball_capacity]
    bool floor;
    float floor_height;
    float scene_center[3]; ///< middle of all skins, knots and balls that are near them, where the
                           ///< floor's shadow is computed
    float scene_radius;    ///< radius of all these about it
} Picture;

struct World; // world/world.h; the renderer never looks inside
struct Mode;  // view/mode.h

/// Room for every line and ball that a display mode can draw of this world. The picture points into
/// the world's meshes: close it before the world.
void picture_open(Picture* picture, const struct World* world);

/// Show the skins of a second world too, one that has been opened like the first.
void picture_ghost(Picture* picture, const struct World* ghost);

/// Fill the picture from the world's present state. Balls come after the knots, in their order.
/// What has not moved since the last time is not computed again.
void picture_update(Picture* picture, const struct World* world, const Camera* camera,
                    const struct Mode* mode);

void picture_close(Picture* picture);

/// Append a line or a ball. There is room for those of one display mode; more is a bug.
void picture_line(Picture* picture, const float from[3], const float to[3], const float color[3],
                  float width);
void picture_ball(Picture* picture, const float center[3], float radius, const float color[3]);

#endif
