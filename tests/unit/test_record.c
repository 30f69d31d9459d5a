// clang-format off
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
// clang-format on

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "world/command.h"
#include "world/record.h"

#define TITLE "# balloon input 1 party\n"

static char folder[] = "/tmp/balloon-record-XXXXXX";
static char file[64];

static int make_folder(void** state) {
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    snprintf(file, sizeof file, "%s/input.log", folder);
    return 0;
}

static int remove_folder(void** state) {
    (void)state;
    remove(file);
    return rmdir(folder);
}

static bool load(const char* text, size_t size, Record* record, Fault* fault) {
    FILE* out = fopen(file, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(text, 1, size, out), size);
    assert_int_equal(fclose(out), 0);
    *fault = (Fault){0};
    return record_load(file, record, fault);
}

static void must_load(const char* text, Record* record) {
    Fault fault;
    if (!load(text, strlen(text), record, &fault))
        fail_msg("%s: %s", fault.location, fault.text);
}

static Event event(long step, EventKind kind, const char* name, const char* value) {
    Event made = {.step = step, .kind = kind};
    snprintf(made.name, sizeof made.name, "%s", name);
    snprintf(made.value, sizeof made.value, "%s", value);
    return made;
}

static void what_is_written_is_read_again(void** state) {
    (void)state;
    Record written = {0};
    FILE* log = fopen(file, "w");
    assert_non_null(log);
    record_title("party", log);
    for (int i = 0; i < 200; i++) {
        const char* name = command_table[i % command_count].name;
        const Event key = event(i / 3, EVENT_KEY, name, i % 2 ? "up" : "down");
        record_add(&written, &key, log);
    }
    const Event set = event(999999999999, EVENT_SET, "balloons.0.color", "[0.5, 0, 1]");
    record_add(&written, &set, log);
    assert_int_equal(fclose(log), 0);

    Record read;
    Fault fault = {0};
    assert_true(record_load(file, &read, &fault));
    assert_int_equal(read.count, written.count);
    for (int i = 0; i < read.count; i++) {
        assert_true(read.event[i].step == written.event[i].step);
        assert_int_equal(read.event[i].kind, written.event[i].kind);
        assert_string_equal(read.event[i].name, written.event[i].name);
        assert_string_equal(read.event[i].value, written.event[i].value);
    }
    record_free(&written);
    record_free(&read);
}

static void events_come_due_once_and_in_order(void** state) {
    (void)state;
    Record record;
    must_load(TITLE "\n# a comment\n0 set gravity 1\n5 set gravity 2\n5 set gravity 3\n"
                    "7 set gravity 4",
              &record);
    assert_int_equal(record.count, 4);
    assert_string_equal(record_due(&record, 0)->value, "1");
    assert_null(record_due(&record, 4));
    assert_string_equal(record_due(&record, 6)->value, "2");
    assert_string_equal(record_due(&record, 6)->value, "3");
    assert_null(record_due(&record, 6));
    assert_string_equal(record_due(&record, 100)->value, "4");
    assert_null(record_due(&record, 100));
    record_free(&record);
}

static void a_log_may_hold_no_events(void** state) {
    (void)state;
    Record record;
    must_load(TITLE, &record);
    assert_int_equal(record.count, 0);
    assert_null(record_due(&record, 100));
    record_free(&record);
}

/// A log with one mistake, the line of the fault and its text.
typedef struct Wrong {
    const char* text;
    int line;
    const char* words;
} Wrong;

#define SIXTY "123456789 123456789 123456789 123456789 123456789 123456789 "

// clang-format off
static const Wrong wrong_table[] = {
    {"1 key inflate down\n",             1, "an input log begins with '# balloon input 1 SCENE'"},
    {"# balloon input 2 party\n",        1, "an input log begins with"},
    {TITLE "key inflate down\n",         2, "an event begins with the number of its step"},
    {TITLE "-1 key inflate down\n",      2, "an event begins with the number of its step"},
    {TITLE " 1 key inflate down\n",      2, "an event begins with the number of its step"},
    {TITLE "1.5 key inflate down\n",     2, "an event begins with the number of its step"},
    {TITLE "1e3 key inflate down\n",     2, "an event begins with the number of its step"},
    {TITLE "9999999999999999999 key inflate down\n", 2, "an event begins with the number of its step"},
    {TITLE "1\n",                        2, "an event begins with the number of its step"},
    {TITLE "\n1 grab 0 0 0\n",           3, "no event 'grab'; there are key, set, throw"},
    {TITLE "1 throw 0 0 0\n",            2, "this is not STEP throw x y z"},
    {TITLE "1 throw 0 0 0 0 0 0 1 -1\n", 2, "a mass and a radius above 0"},
    {TITLE "1 throw 0 0 0 0 0 nan 1 1\n", 2, "numbers that a state of"},
    {TITLE "1 \n",                       2, "no event ''; there are key, set"},
    {TITLE "1 key\n",                    2, "this is not STEP key NAME down|up"},
    {TITLE "1 key inflate\n",            2, "this is not STEP key NAME down|up"},
    {TITLE "1 key inflate \n",           2, "this is not STEP key NAME down|up"},
    {TITLE "1 key inflate sideways\n",   2, "a key goes down or up, and not 'sideways'"},
    {TITLE "1 key inflate down \n",      2, "a key goes down or up, and not 'down '"},
    {TITLE "1 key inflate down\r\n",     2, "a key goes down or up"},
    {TITLE "1 key inflat down\n",        2, "no key 'inflat'; there are inflate"},
    {TITLE "1 set gravity\n",            2, "this is not STEP set KEY VALUE"},
    {TITLE "1 set a " SIXTY SIXTY "\n",  2, "this is not STEP set KEY VALUE"},
    {TITLE "1 set " SIXTY SIXTY SIXTY SIXTY SIXTY SIXTY SIXTY SIXTY SIXTY "\n", 2,
     "it is too long, or not text"},
    {TITLE "2 set a 1\n1 set a 1\n",     3, "step 1 comes after step 2: steps do not run backwards"},
};
// clang-format on

static void what_is_wrong_is_said_with_its_line(void** state) {
    (void)state;
    for (size_t i = 0; i < sizeof wrong_table / sizeof wrong_table[0]; i++) {
        const Wrong* wrong = &wrong_table[i];
        char location[96];
        snprintf(location, sizeof location, "%s:%d", file, wrong->line);
        Record record;
        Fault fault;
        if (load(wrong->text, strlen(wrong->text), &record, &fault))
            fail_msg("this was taken:\n%s", wrong->text);
        if (strcmp(fault.location, location) != 0 || !strstr(fault.text, wrong->words))
            fail_msg("got  %s: %s\nwant %s: … %s …", fault.location, fault.text, location,
                     wrong->words);
        assert_null(record.event);
    }
}

static void files_that_are_no_logs_are_refused(void** state) {
    (void)state;
    Record record;
    Fault fault;
    assert_false(load("", 0, &record, &fault));
    assert_string_equal(fault.text, "this input log is empty");

    static const char zero[] = TITLE "1 set a\0b 1\n";
    assert_false(load(zero, sizeof zero - 1, &record, &fault));
    assert_non_null(strstr(fault.text, "not text"));

    fault = (Fault){0};
    assert_false(record_load(folder, &record, &fault));
    assert_string_equal(fault.location, folder);
    assert_string_equal(fault.text, "it is a folder; name a file in it");

    fault = (Fault){0};
    assert_false(record_load("/dev/zero", &record, &fault));
    assert_string_equal(fault.text, "it is a pipe or a device; name a file");

    fault = (Fault){0};
    assert_false(record_load("/nowhere/input.log", &record, &fault));
    assert_string_equal(fault.text, "it cannot be opened: No such file or directory");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read_again),
        cmocka_unit_test(events_come_due_once_and_in_order),
        cmocka_unit_test(a_log_may_hold_no_events),
        cmocka_unit_test(what_is_wrong_is_said_with_its_line),
        cmocka_unit_test(files_that_are_no_logs_are_refused),
    };
    return cmocka_run_group_tests_name("record", tests, make_folder, remove_folder);
}
