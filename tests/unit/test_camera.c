// The camera: what orbiting, panning and zooming keep, and that matrices and rays agree.
#include "law.h"

#include <stdbool.h>

#include "view/camera.h"

// A handful of single-precision operations on numbers of order ten.
static const double ROUNDING = 2e-5;

static const float ASPECT = 16.0f / 9;

static Camera some_camera(void) {
    return (Camera){.target = {1, 2, -3}, .distance = 5, .yaw = 0.7f, .pitch = 0.3f, .field = 0.6f};
}

// From the world to the picture, -1 … 1 to the right and up; false if behind the eye.
static bool project(const Camera* camera, float aspect, const float point[3], double at[2]) {
    float view[16], projection[16];
    camera_view(camera, view);
    camera_projection(camera, aspect, projection);

    const double world[4] = {point[0], point[1], point[2], 1};
    double seen[4] = {0}, clip[4] = {0};
    for (int i = 0; i < 16; i++)
        seen[i % 4] += view[i] * world[i / 4];
    for (int i = 0; i < 16; i++)
        clip[i % 4] += projection[i] * seen[i / 4];
    at[0] = clip[0] / clip[3];
    at[1] = clip[1] / clip[3];
    return clip[3] > 0 && fabs(clip[2]) <= clip[3];
}

static double distance_to_target(const Camera* camera) {
    float eye[3];
    camera_eye(camera, eye);
    double square = 0;
    for (int i = 0; i < 3; i++)
        square += pow((double)eye[i] - camera->target[i], 2);
    return sqrt(square);
}

static void the_target_is_in_the_middle(void** state) {
    (void)state;
    const Camera camera = some_camera();
    double at[2];
    assert_true(project(&camera, ASPECT, camera.target, at));
    assert_near(at[0], 0, ROUNDING);
    assert_near(at[1], 0, ROUNDING);
}

static void without_yaw_the_eye_looks_along_minus_z(void** state) {
    (void)state;
    Camera camera = some_camera();
    camera.yaw = camera.pitch = 0;
    float eye[3];
    camera_eye(&camera, eye);
    assert_near(eye[0], 1, ROUNDING);
    assert_near(eye[1], 2, ROUNDING);
    assert_near(eye[2], 2, ROUNDING);
}

static void orbiting_keeps_target_and_distance(void** state) {
    (void)state;
    Camera camera = some_camera();
    for (int i = 0; i < 20; i++) {
        camera_orbit(&camera, 0.13f, 0.21f);
        assert_close(distance_to_target(&camera), 5.0, ROUNDING);
        assert_true(fabsf(camera.pitch) <= 1.5f);
    }
    assert_memory_equal(camera.target, some_camera().target, sizeof camera.target);
}

static void panning_moves_what_is_under_the_pointer_along(void** state) {
    (void)state;
    Camera camera = some_camera();
    const Camera before = camera;
    camera_pan(&camera, 0.25f, 0.1f);

    // a quarter of the height to the right, a tenth down: picture coordinates run over two
    double at[2];
    assert_true(project(&camera, 1, before.target, at));
    assert_near(at[0], 0.5, ROUNDING);
    assert_near(at[1], -0.2, ROUNDING);
    assert_close(distance_to_target(&camera), 5.0, ROUNDING);
}

static void zooming_in_and_out_again_changes_nothing(void** state) {
    (void)state;
    Camera camera = some_camera();
    camera_zoom(&camera, 3);
    assert_less(camera.distance, 5 * 0.75);
    camera_zoom(&camera, -3);
    assert_close(camera.distance, 5.0, ROUNDING);
}

static void a_ray_meets_the_point_that_its_pixel_shows(void** state) {
    (void)state;
    const Camera camera = some_camera();
    for (int i = 0; i < 9; i++) {
        const float x = 0.1f + 0.4f * (float)(i % 3), y = 0.05f + 0.45f * (float)(i / 3);
        float eye[3], direction[3], point[3];
        camera_eye(&camera, eye);
        camera_ray(&camera, ASPECT, x, y, direction);
        for (int k = 0; k < 3; k++)
            point[k] = eye[k] + 4 * direction[k];

        double at[2];
        assert_true(project(&camera, ASPECT, point, at));
        assert_near(at[0], 2 * x - 1, ROUNDING);
        assert_near(at[1], 1 - 2 * y, ROUNDING);
    }
}

static void a_framed_box_is_seen_whole_and_fills_the_picture(void** state) {
    (void)state;
    const float boxes[][2][3] = {
        {{-1, 0, -1}, {1, 2, 1}}, {{-9, 3, -1}, {9, 4, 1}}, {{0, 0, -20}, {0.1f, 50, 20}}};
    for (int b = 0; b < 3; b++) {
        const Camera camera = camera_framing(boxes[b][0], boxes[b][1]);
        double widest = 0;
        for (int corner = 0; corner < 8; corner++) {
            float point[3];
            for (int k = 0; k < 3; k++)
                point[k] = boxes[b][corner >> k & 1][k];
            double at[2];
            assert_true(project(&camera, 4.0f / 3, point, at));
            widest = fmax(widest, fmax(fabs(at[0]), fabs(at[1])));
        }
        assert_true(widest <= 1);
        assert_true(widest > 0.8);
    }
}

static void framing_a_point_still_gives_a_camera(void** state) {
    (void)state;
    const float point[3] = {1, 2, 3};
    const Camera camera = camera_framing(point, point);
    assert_true(camera.distance > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_target_is_in_the_middle),
        cmocka_unit_test(without_yaw_the_eye_looks_along_minus_z),
        cmocka_unit_test(orbiting_keeps_target_and_distance),
        cmocka_unit_test(panning_moves_what_is_under_the_pointer_along),
        cmocka_unit_test(zooming_in_and_out_again_changes_nothing),
        cmocka_unit_test(a_ray_meets_the_point_that_its_pixel_shows),
        cmocka_unit_test(a_framed_box_is_seen_whole_and_fills_the_picture),
        cmocka_unit_test(framing_a_point_still_gives_a_camera),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
