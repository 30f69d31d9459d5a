/// The studio: a floor with the soft shadow of everything above it, and a backdrop. In the distance
/// the floor fades into the backdrop, so that no horizon is visible.
#ifndef BALLOON_DRAW_FLOOR_H
#define BALLOON_DRAW_FLOOR_H

#include "base/fault.h"
#include "draw/gl.h"
#include "draw/shadow.h"

typedef struct Floor {
    long stamp;             ///< stamp of the picture that cast the shadow
    GLuint floor, backdrop; ///< programs
    GLuint empty;           ///< vertex array without attributes: shaders compute the corners
    GLuint texture;         ///< the shadow map
    Shadow shadow;
} Floor;

bool floor_open(Floor* floor, const char* shader_dir, Fault* fault);
/// Compute the picture's shadow and upload it, if the picture has a floor.
void floor_upload(Floor* floor, const Picture* picture);
/// Fill all pixels that are still empty: floor, then backdrop.
void floor_draw(const Floor* floor, const Picture* picture);
void floor_close(Floor* floor);

#endif
