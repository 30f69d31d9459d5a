/// Files of results: which may be replaced, and whether they are complete.
#include "law.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "lab/run/result_file.h"

static const char head[] = "scene,ms\n";

/// Write a result; true with no fault.
static bool write_result(const char* folder, const char* name, Fault* fault) {
    FILE* out = result_file_open(folder, name, head, fault);
    if (!out)
        return false;
    fputs(head, out);
    return result_file_close(out, folder, name, fault);
}

static void write_other(const char* folder, const char* name) {
    char path[128];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE* out = fopen(path, "w");
    assert_non_null(out);
    fputs("somebody's own\n", out);
    assert_int_equal(fclose(out), 0);
}

static void remove_all(const char* folder) {
    char command[128];
    snprintf(command, sizeof command, "rm -r %s", folder);
    assert_int_equal(system(command), 0);
}

/// A result replaces an earlier one; it replaces another file only after that is allowed.
static void only_own_files_are_written_over(void** state) {
    (void)state;
    char folder[] = "/tmp/balloon-result-XXXXXX";
    assert_non_null(mkdtemp(folder));
    Fault fault = {0};
    assert_true(write_result(folder, "a.csv", &fault) && write_result(folder, "a.csv", &fault));
    write_other(folder, "b.csv");
    assert_false(write_result(folder, "b.csv", &fault));
    assert_non_null(strstr(fault.location, "/b.csv"));
    assert_non_null(strstr(fault.text, "--overwrite"));
    result_file_overwrite(true);
    fault = (Fault){0};
    assert_true(write_result(folder, "b.csv", &fault));
    result_file_overwrite(false);
    assert_true(write_result(folder, "b.csv", &fault));
    remove_all(folder);
}

static void a_folder_is_made_with_those_above_it(void** state) {
    (void)state;
    char folder[] = "/tmp/balloon-result-XXXXXX", deep[64];
    assert_non_null(mkdtemp(folder));
    snprintf(deep, sizeof deep, "%s/a/b/c", folder);
    Fault fault = {0};
    assert_true(result_folder(deep, &fault) && write_result(deep, "a.csv", &fault));
    snprintf(deep, sizeof deep, "%s/a/b/c/a.csv/d", folder);
    assert_false(result_folder(deep, &fault));
    assert_non_null(strstr(fault.text, "cannot be made"));
    remove_all(folder);
}

static void a_full_disk_is_a_fault(void** state) {
    (void)state;
    char folder[] = "/tmp/balloon-result-XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/a.csv", folder);
    assert_int_equal(symlink("/dev/full", path), 0);
    Fault fault = {0};
    assert_false(write_result(folder, "a.csv", &fault));
    assert_non_null(strstr(fault.text, "could not be written to its end"));
    remove_all(folder);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_own_files_are_written_over),
        cmocka_unit_test(a_folder_is_made_with_those_above_it),
        cmocka_unit_test(a_full_disk_is_a_fault),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
