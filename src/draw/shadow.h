/// The soft shadow on the floor, computed on the CPU as a small map seen from above.
///
/// Every piece of surface that faces away from a light absorbs some of the floor's light:
///
///     sky   a piece of area A at height h absorbs A h^2 / (pi (r^2 + h^2)^2) of a uniform sky's
///           light at distance r: a bump of integral A and of a half-mass radius h
///     key   a soft box projects the piece along its own direction, blurred by its angular size
///
/// so an object close to the floor casts a dark, sharp shadow and a high one a faint, wide shadow. A
/// bump is a cubic B-spline on the grid of a pyramid whose spacing fits the blur; each grid is
/// refined to the next finer one by B-spline subdivision and added to it. The work is linear in
/// triangles and in pixels for any blur; drawing the scene from above would cost the software
/// renderer ten times as much.
///
/// Colored rubber transmits some light of its color, so shadows are tinted.
#ifndef BALLOON_DRAW_SHADOW_H
#define BALLOON_DRAW_SHADOW_H

#include "view/picture.h"

enum {
    SHADOW_LEVELS = 6,              ///< grids, each with half the cells per side of the last
    SHADOW_CELLS = 160,             ///< cells per side of the finest: a multiple of 2^(LEVELS-1)
    SHADOW_SIDE = SHADOW_CELLS + 1, ///< points per side of the map
};

typedef float float4 __attribute__((vector_size(16)));

typedef struct Shadow {
    float4* level[SHADOW_LEVELS]; ///< optical depth in red, green, blue; rows along x
    unsigned char (*light)[4];    ///< [SHADOW_SIDE in z][SHADOW_SIDE in x] light that reaches the
                                  ///< floor: red, green, blue 0…255, unused
} Shadow;

Shadow shadow_open(void);

/// Half the width of the map: beyond 2.5 scene radii no shadow is visible.
static inline float shadow_reach(const Picture* picture) {
    return 2.5f * (picture->scene_radius > 0 ? picture->scene_radius : 1);
}

/// Compute `light` for a picture; FrameBlock.shadow has the map's corner and width.
void shadow_cast(Shadow* shadow, const Picture* picture);

void shadow_close(Shadow* shadow);

#endif
