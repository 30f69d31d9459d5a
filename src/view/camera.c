#include "view/camera.h"

#include <math.h>
#include <string.h>

#include <cglm/cglm.h>

#include "base/real.h"

// A drag over the height of the window rotates the scene by half a circle.
static const float RADIANS_PER_HEIGHT = (float)PI;
// Below pi / 2: looking straight up or down, the direction "up" is undefined. [rad]
static const float PITCH_LIMIT = 1.5f;
static const float ZOOM_PER_STEP = 0.9f;
// The near and the far plane over the distance: 24 bits of depth then resolve 1e-4 of the distance.
static const float NEAR_RATIO = 0.02f;
static const float FAR_RATIO = 60.0f;
// A framed box is fully visible in windows down to this width over height, with a margin around it.
static const float NARROWEST = 4.0f / 3;
static const float MARGIN = 1.06f;

// Unit vectors of the eye: right, up, and forward from the eye to the target.
static void axes(const Camera* camera, vec3 right, vec3 up, vec3 forward) {
    const float cy = cosf(camera->yaw), sy = sinf(camera->yaw);
    const float cp = cosf(camera->pitch), sp = sinf(camera->pitch);
    glm_vec3_copy((vec3){cy, 0, -sy}, right);
    glm_vec3_copy((vec3){-sy * sp, cp, -cy * sp}, up);
    glm_vec3_copy((vec3){-sy * cp, -sp, -cy * cp}, forward);
}

// The distance of the eye at which a point, relative to the target, lies on the picture's edge.
static float distance_to_fit(const vec3 point, vec3 right, vec3 up, vec3 forward, float half) {
    vec3 p = {point[0], point[1], point[2]};
    const float x = fabsf(glm_vec3_dot(p, right)) / (half * NARROWEST);
    const float y = fabsf(glm_vec3_dot(p, up)) / half;
    return glm_max(x, y) - glm_vec3_dot(p, forward);
}

Camera camera_framing(const float low[3], const float high[3]) {
    Camera camera = {.field = 0.6f, .yaw = 0.3f, .pitch = 0.12f};
    for (int i = 0; i < 3; i++)
        camera.target[i] = 0.5f * (low[i] + high[i]);

    vec3 right, up, forward;
    axes(&camera, right, up, forward);
    const float half = tanf(0.5f * camera.field);
    for (int corner = 0; corner < 8; corner++) {
        vec3 point;
        for (int i = 0; i < 3; i++)
            point[i] = (corner >> i & 1 ? high[i] : low[i]) - camera.target[i];
        camera.distance =
            glm_max(camera.distance, MARGIN * distance_to_fit(point, right, up, forward, half));
    }
    if (!(camera.distance > 0))
        camera.distance = 1;
    return camera;
}

void camera_orbit(Camera* camera, float dx, float dy) {
    camera->yaw -= RADIANS_PER_HEIGHT * dx;
    camera->pitch += RADIANS_PER_HEIGHT * dy;
    camera->pitch = glm_clamp(camera->pitch, -PITCH_LIMIT, PITCH_LIMIT);
}

void camera_pan(Camera* camera, float dx, float dy) {
    vec3 right, up, forward;
    axes(camera, right, up, forward);

    // a point at the target's depth stays under the pointer
    const float height = 2 * camera->distance * tanf(0.5f * camera->field);
    for (int i = 0; i < 3; i++)
        camera->target[i] += height * (dy * up[i] - dx * right[i]);
}

void camera_zoom(Camera* camera, float steps) {
    camera->distance *= powf(ZOOM_PER_STEP, steps);
}

void camera_eye(const Camera* camera, float eye[3]) {
    vec3 right, up, forward;
    axes(camera, right, up, forward);
    for (int i = 0; i < 3; i++)
        eye[i] = camera->target[i] - camera->distance * forward[i];
}

void camera_view(const Camera* camera, float view[16]) {
    vec3 right, up, forward, eye;
    axes(camera, right, up, forward);
    camera_eye(camera, eye);

    mat4 matrix;
    glm_look(eye, forward, up, matrix);
    memcpy(view, matrix, sizeof matrix);
}

void camera_projection(const Camera* camera, float aspect, float projection[16]) {
    mat4 matrix;
    glm_perspective(camera->field, aspect, NEAR_RATIO * camera->distance,
                    FAR_RATIO * camera->distance, matrix);
    memcpy(projection, matrix, sizeof matrix);
}

void camera_ray(const Camera* camera, float aspect, float x, float y, float direction[3]) {
    vec3 right, up, forward;
    axes(camera, right, up, forward);

    const float half = tanf(0.5f * camera->field);
    const float across = (2 * x - 1) * half * aspect, above = (1 - 2 * y) * half;
    vec3 ray;
    for (int i = 0; i < 3; i++)
        ray[i] = forward[i] + across * right[i] + above * up[i];
    glm_vec3_normalize_to(ray, direction);
}
