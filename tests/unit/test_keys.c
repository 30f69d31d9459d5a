/// Keys and sessions: no key twice, and what was logged is replayed to the same bits.
#include "worlds.h"

#include "show/keys.h"
#include "show/session.h"
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
        const PanelKey row = keys_row(k);
        assert_true((command_key_find(row.key) >= 0) != (view_key_find(row.key) != NULL));
        assert_true(row.about[0] != 0);
    }
    assert_null(view_key_find("no such key"));
    assert_int_equal(command_key_find("no such key"), -1);
}

static void all_keys_fit_the_help_box(void** state) {
    (void)state;
    assert_true(keys_count() <= PANEL_KEYS);
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
    session_close(&session);
    const uint64_t want = world_hash(&world);
    world_close(&world);

    WORLD_OF(&world, "tether");
    assert_true(session_open(&session, &world, record, NULL, &fault));
    step(&session, 100);
    session_close(&session);
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
    assert_true(session_change(&session, &next, &fault));
    assert_int_equal(world.balloon[0].mesh.point_count, 8);
    key(&session, "inflate", true);
    step(&session, 2);
    session_close(&session);
    world_close(&world);

    Record read;
    assert_true(record_load(second, &read, &fault));
    assert_int_equal(read.count, 1);
    assert_int_equal(read.event[0].step, 0);
    record_free(&read);
    unlink(second);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_key_stands_twice),
        cmocka_unit_test(every_key_is_found_in_one_table),
        cmocka_unit_test(all_keys_fit_the_help_box),
        cmocka_unit_test(a_session_is_replayed_to_the_same_bits),
        cmocka_unit_test(another_scene_gets_a_log_of_its_own),
    };
    return cmocka_run_group_tests(tests, open_record, close_record);
}
