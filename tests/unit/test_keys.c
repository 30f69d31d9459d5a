/// Keys, throws and sessions: no key has two meanings, a ball flies toward the pointer, and a
/// replayed log gives the same bits.
#include "worlds.h"

#include "show/keys.h"
#include "show/session.h"
#include "view/framing.h"
#include "view/thrower.h"
#include "world/command.h"

static void no_key_stands_twice(void** state) {
    (void)state;
    for (int a = 0; a < keys_count(); a++)
        for (int b = 0; b < a; b++)
            assert_string_not_equal(keys_row(a).key, keys_row(b).key);
}

static void every_key_is_found_in_one_table(void** state) {
    (void)state;
    for (int k = 0; k < keys_count(); k++) {
        const OverlayKey row = keys_row(k);
        assert_true((command_key_find(row.key) >= 0) != (view_key_find(row.key) != NULL));
        assert_true(row.about[0] != 0);
    }
    assert_null(view_key_find("no such key"));
    assert_int_equal(command_key_find("no such key"), -1);
}

static void all_keys_fit_the_help_box(void** state) {
    (void)state;
    assert_true(keys_count() <= OVERLAY_KEYS);
}

/// A balloon that flew off untied is tied where it is: a string of the old length would pull one
/// particle by many times the balloon's size in a step.
static void a_string_is_tied_again_where_the_balloon_is(void** state) {
    (void)state;
    World world;
    WORLD_OF(&world, "tether", "balloons.0.strings.0.stiffness=5000");
    const uint64_t start = world_hash(&world);
    press(&world, "string", "down");
    run_for(&world, 4);
    assert_less(2.5, probe(&world, "balloon0.cy"));
    press(&world, "string", "down");
    assert_near(probe(&world, "balloon0.string0.tension"), 0, 0.1);
    run_for(&world, 1);
    assert_false(world.blowup.halted);
    assert_less(1, probe(&world, "balloon0.string0.tension"));
    press(&world, "reset", "down");
    assert_true(world_hash(&world) == start);
    run_for(&world, 2);
    assert_less(probe(&world, "balloon0.cy"), 0.5); // on the string of its scene
    world_close(&world);
}

static char record[32];

static int open_record(void** state) {
    (void)state;
    snprintf(record, sizeof record, "/tmp/balloon-XXXXXX");
    const int file = mkstemp(record);
    return file < 0 ? -1 : close(file);
}

static int close_record(void** state) {
    (void)state;
    return unlink(record);
}

static void step(Session* session, int count) {
    Fault fault = {0};
    for (int n = 0; n < count; n++)
        assert_true(session_step(session, &fault));
}

static void key(Session* session, const char* name, bool down) {
    Fault fault = {0};
    assert_true(session_key(session, command_find(name), down, &fault));
}

static void a_session_is_replayed_to_the_same_bits(void** state) {
    (void)state;
    World world;
    Session session;
    Fault fault = {0};
    WORLD_OF(&world, "tether");
    assert_true(session_open(&session, &world, NULL, record, &fault));
    key(&session, "inflate", true);
    step(&session, 40);
    key(&session, "reset", true);
    key(&session, "reset", false);
    step(&session, 10);
    key(&session, "deflate", true);
    key(&session, "string", true);
    step(&session, 30);
    key(&session, "deflate", false);
    step(&session, 20);
    assert_true(session_close(&session, &fault));
    const uint64_t want = world_hash(&world);
    world_close(&world);

    WORLD_OF(&world, "tether");
    assert_true(session_open(&session, &world, record, NULL, &fault));
    step(&session, 100);
    assert_true(session_close(&session, &fault));
    assert_true(world_hash(&world) == want);
    world_close(&world);
}

static void another_scene_gets_a_log_of_its_own(void** state) {
    (void)state;
    World world, next;
    Session session;
    Fault fault = {0};
    char second[64];
    snprintf(second, sizeof second, "%s.2", record);
    WORLD_OF(&world, "tether");
    WORLD_OF(&next, "cube");
    assert_true(session_open(&session, &world, NULL, record, &fault));
    step(&session, 3);
    assert_true(session_change(&session, &next, NULL, &fault));
    assert_int_equal(world.balloon[0].mesh.point_count, 8);
    key(&session, "inflate", true);
    step(&session, 2);
    assert_true(session_close(&session, &fault));
    world_close(&world);

    Record read;
    assert_true(record_load(second, &read, &fault));
    assert_int_equal(read.count, 1);
    assert_int_equal(read.event[0].step, 0);
    record_free(&read);
    unlink(second);
}

// ---- throws ----

static const float ASPECT = 16.0f / 9;

typedef struct Aimer {
    World world;
    Camera camera;
    Thrower thrower;
} Aimer;

static void aimer_open(Aimer* aimer, const char* const* words) {
    world_of_list(&aimer->world, words);
    aimer->camera = framing_first(&aimer->world);
    aimer->thrower = thrower_default(&aimer->world, &aimer->camera);
}

#define AIMER(aimer, ...) aimer_open((aimer), (const char* const[]){__VA_ARGS__, NULL})

static bool aim(const Aimer* aimer, float x, float y, double thrown[THROW_NUMBERS]) {
    return thrower_throw(&aimer->thrower, &aimer->world, &aimer->camera, ASPECT,
                         (const float[]){x, y}, thrown);
}

static double from_eye(const Camera* camera, const double point[3]) {
    float eye[3];
    camera_eye(camera, eye);
    return sqrt(pow(point[0] - (double)eye[0], 2) + pow(point[1] - (double)eye[1], 2) +
                pow(point[2] - (double)eye[2], 2));
}

/// Position of a point in the window, 0 … 1 from the upper left.
static void seen_at(const Camera* camera, const double point[3], double at[2]) {
    float view[16], projection[16];
    camera_view(camera, view);
    camera_projection(camera, ASPECT, projection);
    const double from[4] = {point[0], point[1], point[2], 1};
    double seen[4] = {0}, clip[4] = {0};
    for (int i = 0; i < 16; i++)
        seen[i % 4] += (double)view[i] * from[i / 4];
    for (int i = 0; i < 16; i++)
        clip[i % 4] += (double)projection[i] * seen[i / 4];
    at[0] = 0.5 + 0.5 * clip[0] / clip[3];
    at[1] = 0.5 - 0.5 * clip[1] / clip[3];
}

static void a_ball_flies_from_the_eye_through_the_pixel_pointed_at(void** state) {
    (void)state;
    Aimer aimer;
    AIMER(&aimer, "tether");
    for (int i = 0; i < 9; i++) {
        const float x = 0.2f + 0.3f * (float)(i % 3), y = 0.1f + 0.3f * (float)(i / 3);
        double thrown[THROW_NUMBERS], later[3], at[2];
        assert_true(aim(&aimer, x, y, thrown));
        assert_less(from_eye(&aimer.camera, thrown), 0.5 * (double)aimer.camera.distance);
        for (int k = 0; k < 3; k++)
            later[k] = thrown[k] + 0.1 * thrown[3 + k];
        assert_less(from_eye(&aimer.camera, thrown), from_eye(&aimer.camera, later));

        // the matrices and the ray are single precision, of numbers of order ten
        for (int part = 0; part < 2; part++) {
            seen_at(&aimer.camera, part ? later : thrown, at);
            assert_near(at[0], (double)x, 2e-5);
            assert_near(at[1], (double)y, 2e-5);
        }
        const double speed =
            sqrt(thrown[3] * thrown[3] + thrown[4] * thrown[4] + thrown[5] * thrown[5]);
        assert_close(speed, aimer.thrower.speed, 1e-12);
    }
    world_close(&aimer.world);
}

/// At every distance of the eye, up to the box of the balloon.
static void a_ball_starts_in_front_of_the_balloon(void** state) {
    (void)state;
    Aimer aimer;
    AIMER(&aimer, "cube-sphere:6", "balloons.0.strings=[]");
    aimer.camera.pitch = aimer.camera.yaw = 0;
    for (double gap = 10; gap > 0.01; gap /= 2) {
        double thrown[THROW_NUMBERS];
        // the sphere's radius is 1, its middle the origin; the eye is at +z
        aimer.camera.distance = (float)(1 + aimer.thrower.radius + gap);
        assert_true(aim(&aimer, 0.5f, 0.5f, thrown));
        assert_true(thrown[2] >= 1 + aimer.thrower.radius - 1e-5);
        assert_true(from_eye(&aimer.camera, thrown) >= 0);
    }
    world_close(&aimer.world);
}

static void a_ball_starts_above_the_floor_or_not_at_all(void** state) {
    (void)state;
    Aimer aimer;
    AIMER(&aimer, "tether");
    double thrown[THROW_NUMBERS];
    aimer.camera.pitch = -0.5f; // from below the floor at -4, past it upward
    assert_true(aim(&aimer, 0.5f, 0.5f, thrown));
    assert_true(thrown[1] >= -4 + aimer.thrower.radius - 1e-9);
    aimer.camera.target[1] = -30;
    assert_false(aim(&aimer, 0.5f, 0.5f, thrown));
    world_close(&aimer.world);
}

static void a_ball_waits_until_the_one_before_has_left(void** state) {
    (void)state;
    Aimer aimer;
    Session session;
    Fault fault = {0};
    AIMER(&aimer, "tether");
    assert_true(session_open(&session, &aimer.world, NULL, NULL, &fault));
    double thrown[THROW_NUMBERS];
    assert_true(aim(&aimer, 0.1f, 0.1f, thrown));
    assert_true(session_throw(&session, thrown, &fault));
    assert_false(aim(&aimer, 0.1f, 0.1f, thrown));
    step(&session, 2 + (int)(2 * aimer.thrower.radius / aimer.thrower.speed / aimer.world.step));
    assert_true(aim(&aimer, 0.1f, 0.1f, thrown));
    assert_true(session_close(&session, &fault));
    world_close(&aimer.world);
}

static void the_hand_goes_through_all_its_balls(void** state) {
    (void)state;
    const Thrower first = {.mass = 0.1, .radius = 0.05, .speed = 1};
    Thrower thrower = first;
    for (int k = 1; k < 5; k++) {
        thrower_next_mass(&thrower);
        thrower_next_radius(&thrower);
        assert_close(thrower.mass, 0.1 * pow(10, k), 1e-12);
        assert_close(thrower.radius, 0.05 * pow(2, k), 1e-12);
    }
    thrower_next_mass(&thrower);
    thrower_next_radius(&thrower);
    for (int k = 0; k < 7; k++) {
        const double before = thrower.speed;
        thrower_next_speed(&thrower);
        assert_true(k == 6 || thrower.speed > before);
    }
    assert_memory_equal(&thrower, &first, sizeof thrower);
}

/// The tether's sphere is 2 wide and weighs 0.386: an eighth of that is 0.25, and 0.386 is nearer
/// to 1 than to 0.1.
static void the_first_ball_suits_the_scene(void** state) {
    (void)state;
    Aimer aimer;
    AIMER(&aimer, "tether");
    assert_near(aimer.thrower.radius, 0.2, 0);
    assert_near(aimer.thrower.mass, 1, 0);
    const double fall = 4.9 * pow((double)aimer.camera.distance / aimer.thrower.speed, 2);
    assert_less(fall, 0.5);
    world_close(&aimer.world);
}

static void a_throw_is_logged_and_replayed_to_the_same_bits(void** state) {
    (void)state;
    Aimer aimer;
    Session session;
    Fault fault = {0};
    double thrown[THROW_NUMBERS];
    AIMER(&aimer, "tether");
    assert_true(session_open(&session, &aimer.world, NULL, record, &fault));
    step(&session, 20);
    assert_true(aim(&aimer, 0.5f, 0.5f, thrown));
    assert_true(session_throw(&session, thrown, &fault));
    step(&session, 20);
    thrower_next_mass(&aimer.thrower);
    assert_true(aim(&aimer, 0.45f, 0.55f, thrown));
    assert_true(session_throw(&session, thrown, &fault));
    step(&session, 60);
    assert_true(session_close(&session, &fault));
    assert_int_equal(aimer.world.contacts.sphere_count, 2);
    const uint64_t want = world_hash(&aimer.world);
    world_close(&aimer.world);

    Record read;
    assert_true(record_load(record, &read, &fault));
    assert_int_equal(read.count, 2);
    assert_int_equal(read.event[0].kind, EVENT_THROW);
    assert_int_equal(read.event[0].step, 20);
    assert_memory_equal(read.event[1].thrown, thrown, sizeof thrown);
    record_free(&read);

    World world;
    WORLD_OF(&world, "tether");
    assert_true(session_open(&session, &world, record, NULL, &fault));
    step(&session, 100);
    assert_true(session_close(&session, &fault));
    assert_true(world_hash(&world) == want);
    world_close(&world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_key_stands_twice),
        cmocka_unit_test(every_key_is_found_in_one_table),
        cmocka_unit_test(a_string_is_tied_again_where_the_balloon_is),
        cmocka_unit_test(all_keys_fit_the_help_box),
        cmocka_unit_test(a_session_is_replayed_to_the_same_bits),
        cmocka_unit_test(another_scene_gets_a_log_of_its_own),
        cmocka_unit_test(a_ball_flies_from_the_eye_through_the_pixel_pointed_at),
        cmocka_unit_test(a_ball_starts_in_front_of_the_balloon),
        cmocka_unit_test(a_ball_starts_above_the_floor_or_not_at_all),
        cmocka_unit_test(a_ball_waits_until_the_one_before_has_left),
        cmocka_unit_test(the_hand_goes_through_all_its_balls),
        cmocka_unit_test(the_first_ball_suits_the_scene),
        cmocka_unit_test(a_throw_is_logged_and_replayed_to_the_same_bits),
    };
    return cmocka_run_group_tests(tests, open_record, close_record);
}
