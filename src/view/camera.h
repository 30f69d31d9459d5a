/// The eye: orbits a target, pans, zooms. y is up.
#ifndef BALLOON_VIEW_CAMERA_H
#define BALLOON_VIEW_CAMERA_H

typedef struct Camera {
    float target[3]; ///< what the eye looks at
    float distance;  ///< from the target to the eye
    float yaw;       ///< [rad] about y, 0 looks along -z, more moves the eye towards +x
    float pitch;     ///< [rad] above the horizon, held within +-1.5
    float field;     ///< [rad] vertical field of view
} Camera;

/// Looks at the middle of a box from a little above and aside, just far enough to see all of it in
/// a window that is at least four thirds as wide as high.
Camera camera_framing(const float low[3], const float high[3]);

/// dx, dy: the drag in heights of the window, so that a wide window orbits no faster.
void camera_orbit(Camera* camera, float dx, float dy);
void camera_pan(Camera* camera, float dx, float dy);
/// steps > 0 moves closer, a tenth of the distance each.
void camera_zoom(Camera* camera, float steps);

void camera_eye(const Camera* camera, float eye[3]);
/// Column-major 4x4 matrices as OpenGL takes them; near and far follow the distance.
void camera_view(const Camera* camera, float view[16]);
void camera_projection(const Camera* camera, float aspect, float projection[16]);
/// The direction of a ray through the pixel at (x, y), each 0…1 from the window's upper left.
void camera_ray(const Camera* camera, float aspect, float x, float y, float direction[3]);

#endif
