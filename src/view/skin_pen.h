/// Lines and balls that the display modes draw on a skin: slightly above it, and only where it
/// faces the eye, so that the far side does not clutter the picture.
#ifndef BALLOON_VIEW_SKIN_PEN_H
#define BALLOON_VIEW_SKIN_PEN_H

#include "view/picture.h"
#include "world/world.h"

/// Linear colors.
extern const float PEN_BLACK[3], PEN_RED[3], PEN_BLUE[3], PEN_GREEN[3], PEN_ORANGE[3];

enum { PEN_EDGE = 18 }; ///< edge length for which line widths are stated [px at 720 lines]

typedef struct SkinPen {
    Picture* picture;
    const PictureSkin* skin;
    float edge_length; ///< mean length of an edge: the unit of all sizes drawn on a skin
    float width_scale; ///< factor on line widths
    float eye[3];
} SkinPen;

SkinPen skin_pen_on(Picture* picture, const PictureSkin* skin, const Balloon* balloon);

/// Whether the outside of a closed skin at point i faces away from the eye.
bool skin_pen_hidden(const SkinPen* pen, int i);

/// Point i, `raise` edge lengths above the skin.
void skin_pen_above(const SkinPen* pen, int i, float raise, float out[3]);

/// Draw a line between two points of the skin, unless both are hidden. The width is that for edges
/// of PEN_EDGE pixels and shrinks with them.
void skin_pen_line(const SkinPen* pen, const int end[2], float raise, const float color[3],
                   float width);

#endif
