/// The eye: orbits a target, pans, zooms. y is up.
#ifndef BALLOON_VIEW_CAMERA_H
#define BALLOON_VIEW_CAMERA_H

typedef struct Camera {
    float target[3]; ///< the point that the eye looks at
    float distance;  ///< from the target to the eye
    float yaw;       ///< [rad] about y: at 0 the eye looks along -z; a larger yaw moves it to +x
    float pitch;     ///< [rad] of the eye above the target's height, within -1.5…1.5
    float field;     ///< [rad] vertical field of view
} Camera;

/// A camera that looks at the center of a box from slightly above and to the side. The box just
/// fits in a window that is at least four thirds as wide as high.
Camera camera_framing(const float low[3], const float high[3]);

/// dx, dy: the drag in units of the window's height, so that a wide window orbits no faster.
void camera_orbit(Camera* camera, float dx, float dy);
void camera_pan(Camera* camera, float dx, float dy);
/// Move closer by a tenth of the distance for each step; negative steps move away.
void camera_zoom(Camera* camera, float steps);

void camera_eye(const Camera* camera, float eye[3]);
/// Column-major 4x4 matrices in OpenGL's convention; the near and the far plane scale with the
/// distance.
void camera_view(const Camera* camera, float view[16]);
void camera_projection(const Camera* camera, float aspect, float projection[16]);
/// The direction of a ray through the pixel at (x, y), each 0…1 from the window's upper left.
void camera_ray(const Camera* camera, float aspect, float x, float y, float direction[3]);

#endif
