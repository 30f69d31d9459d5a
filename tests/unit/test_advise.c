/// The cache of advice: cached points are read back; any other file in its place is ignored.
#include <dirent.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "lab/advice/advise.h"
#include "law.h"

static char folder[64] = "/tmp/balloon-XXXXXX";
static const char scene[] = "step: \"0.002\"\nballoons: \"3\"\n";

static Advice sample(void) {
    Advice advice = {.count = 2, .floor = 1e-4, .outputs = 1, .reference = {2.5}};
    advice.point = new_array(AdvicePoint, 2);
    advice.point[0] = (AdvicePoint){"euler", "float", 0, 0.002, 0.01, 1.5};
    advice.point[1] = (AdvicePoint){"newton", "double", -1, 0.01, INFINITY, 0};
    return advice;
}

/// Path of the cache's only file.
static void find_file(char path[512]) {
    char cache[128];
    snprintf(cache, sizeof cache, "%s/balloon", folder);
    DIR* list = opendir(cache);
    assert_non_null(list);
    for (const struct dirent* entry; (entry = readdir(list));)
        if (entry->d_name[0] != '.')
            snprintf(path, 512, "%s/%s", cache, entry->d_name);
    closedir(list);
}

static void put_file(const char* path, const char* text, size_t size) {
    FILE* out = fopen(path, "w");
    assert_non_null(out);
    fwrite(text, 1, size, out);
    fclose(out);
}

static bool is_recalled(void) {
    Advice advice;
    const bool found = advise_cache_read(scene, 1, &advice);
    advise_free(&advice);
    return found;
}

static void what_is_kept_is_recalled(void** state) {
    (void)state;
    Advice cached = sample(), found;
    advise_cache_write(scene, &cached);
    assert_true(advise_cache_read(scene, 1, &found));
    assert_int_equal(found.count, 2);
    assert_true(found.floor == cached.floor && found.reference[0] == cached.reference[0]);
    assert_string_equal(found.point[1].method, "newton");
    assert_true(isinf(found.point[1].error));
    assert_true(found.point[0].step == cached.point[0].step &&
                found.point[0].ms == cached.point[0].ms);
    advise_free(&found);
    assert_true(
        advise_cache_read("step: \"0.0021\"\nballoons: \"3\"\n", 1, &found)); // within a fifth
    advise_free(&found);
    assert_false(advise_cache_read("step: \"0.003\"\nballoons: \"3\"\n", 1, &found));
    assert_false(advise_cache_read(scene, 2, &found)); // more outputs than were measured
    advise_free(&cached);
}

/// Every single byte changed, and the file truncated after every byte.
static void a_damaged_file_is_ignored(void** state) {
    (void)state;
    Advice cached = sample();
    char path[512], text[4096];
    advise_cache_write(scene, &cached);
    find_file(path);
    FILE* in = fopen(path, "r");
    const size_t size = fread(text, 1, sizeof text, in);
    fclose(in);
    for (size_t k = 0; k < size; k++) {
        put_file(path, text, k);
        assert_false(is_recalled());
        text[k] ^= 1;
        put_file(path, text, size);
        assert_false(is_recalled());
        text[k] ^= 1;
    }
    put_file(path, text, size);
    assert_true(is_recalled());
    advise_free(&cached);
}

/// Values that no measurement gives, in a file with a correct hash.
static void an_impossible_file_is_ignored(void** state) {
    (void)state;
    enum { CASES = 12 };
    for (int k = 0; k < CASES; k++) {
        Advice cached = sample();
        AdvicePoint* p = &cached.point[0];
        const double nan_value = (double)NAN;
        // clang-format off
        switch (k) {
        case 0: p->error = nan_value; break;
        case 1: p->ms = nan_value; break;
        case 2: p->step = nan_value; break;
        case 3: p->error = -1; break;
        case 4: p->step = 0; break;
        case 5: p->refinement = 1000000; break;
        case 6: strcpy(p->method, "magic"); break;
        case 7: strcpy(p->precision, "half"); break;
        case 8: cached.floor = nan_value; break;
        case 9: cached.reference[0] = nan_value; break;
        case 10: cached.count = 0; break;
        case 11: cached.floor = INFINITY; break;
        }
        // clang-format on
        advise_cache_write(scene, &cached);
        if (is_recalled())
            fail_msg("case %d is believed", k);
        advise_free(&cached);
    }
}

/// A pipe or a folder at the cache's path does not block the program and is not read.
static void what_is_no_file_is_ignored(void** state) {
    (void)state;
    Advice cached = sample();
    char path[512];
    advise_cache_write(scene, &cached);
    find_file(path);
    unlink(path);
    assert_int_equal(mkfifo(path, 0600), 0);
    assert_false(is_recalled());
    advise_cache_write(scene, &cached); // replaces the pipe
    assert_true(is_recalled());
    unlink(path);
    assert_int_equal(mkdir(path, 0700), 0);
    assert_false(is_recalled());
    advise_cache_write(scene, &cached); // fails with a message only
    rmdir(path);
    setenv("XDG_CACHE_HOME", "/proc/nothing", 1);
    assert_false(is_recalled());
    advise_cache_write(scene, &cached);
    setenv("XDG_CACHE_HOME", folder, 1);
    advise_free(&cached);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_kept_is_recalled),
        cmocka_unit_test(a_damaged_file_is_ignored),
        cmocka_unit_test(an_impossible_file_is_ignored),
        cmocka_unit_test(what_is_no_file_is_ignored),
    };
    if (!mkdtemp(folder))
        return 1;
    setenv("XDG_CACHE_HOME", folder, 1);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    char path[512] = "";
    find_file(path);
    unlink(path);
    snprintf(path, sizeof path, "%s/balloon", folder);
    rmdir(path);
    rmdir(folder);
    return failed;
}
