/// Lines and balls drawn on a skin by the display modes: a little above it, and only where it faces
/// the eye, so that the far side does not clutter the picture.
#ifndef BALLOON_VIEW_STROKE_H
#define BALLOON_VIEW_STROKE_H

#include "view/picture.h"
#include "world/world.h"

/// linear light
extern const float STROKE_BLACK[3], STROKE_RED[3], STROKE_BLUE[3], STROKE_GREEN[3],
    STROKE_ORANGE[3];

enum { STROKE_EDGE = 18 }; ///< [px at 720 lines]

typedef struct Stroke {
    Picture* picture;
    const PictureSkin* skin;
    float grain; ///< mean length of an edge: the measure of all that is drawn on a skin
    float thin;  ///< factor on widths
    float eye[3];
} Stroke;

Stroke stroke_on(Picture* picture, const PictureSkin* skin, const Balloon* balloon);

/// Whether the outside of a closed skin at point i is turned away from the eye.
bool stroke_hidden(const Stroke* stroke, int i);

/// Point i, `raise` edge lengths above the skin.
void stroke_above(const Stroke* stroke, int i, float raise, float out[3]);

/// A line between two points of the skin, none if both are hidden. Its width is for edges of
/// STROKE_EDGE pixels; where edges are shorter in the picture it is thinner.
void stroke_line(const Stroke* stroke, const int end[2], float raise, const float color[3],
                 float width);

#endif
