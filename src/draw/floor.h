/// The studio: a floor with the soft shadow of all that is above it, which fades into the backdrop
/// far away, so that no horizon is seen.
#ifndef BALLOON_DRAW_FLOOR_H
#define BALLOON_DRAW_FLOOR_H

#include "base/fault.h"
#include "draw/gl.h"
#include "draw/shadow.h"

typedef struct Floor {
    long stamp;             ///< stamp of the picture whose shadow it is
    GLuint floor, backdrop; ///< programs
    GLuint empty;           ///< vertex array without attributes: shaders make the corners
    GLuint texture;         ///< the shadow map
    Shadow shadow;
} Floor;

bool floor_open(Floor* floor, const char* shader_dir, Fault* fault);
/// Cast the picture's shadow and hand it to the driver; nothing without a floor.
void floor_upload(Floor* floor, const Picture* picture);
/// Fill all pixels that nothing has been drawn on.
void floor_draw(const Floor* floor, const Picture* picture);
void floor_close(Floor* floor);

#endif
