/// The stored inputs of make fuzz, former faults and valid inputs: every reader returns.
#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#include "../fuzz/targets.h"

static int replay(const struct FuzzTarget* target) {
    char folder[200];
    int count = 0;
    snprintf(folder, sizeof folder, "tests/fuzz/corpus/%s", target->name);
    DIR* entries = opendir(folder);
    assert_non_null(entries);
    const struct dirent* entry;
    while ((entry = readdir(entries))) {
        char path[600];
        static uint8_t data[1 << 16];
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        FILE* in = entry->d_name[0] == '.' ? NULL : fopen(path, "rb");
        if (!in)
            continue;
        target->run(data, fread(data, 1, sizeof data, in));
        fclose(in);
        count++;
    }
    closedir(entries);
    return count;
}

static void every_kept_input_is_read_or_refused(void** state) {
    (void)state;
    for (int k = 0; k < FUZZ_TARGETS; k++)
        assert_true(replay(&fuzz_table[k]) > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_kept_input_is_read_or_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
