/// Every verb without options and with each one alone: it ends by itself or, if it measures for
/// minutes, after an interrupt; never by a memory error, a failed assertion or a hang.
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/paths.h"
#include "base/table.h"
#include "cli/verb.h"

enum {
    PATIENCE = 15,      ///< time until a verb is interrupted [10 ms]
    FORBEARANCE = 2000, ///< maximum time for an interrupted one to end [10 ms]
};

static char scratch[] = "/tmp/test_verbs-XXXXXX", program[600];

/// A scene of a few steps, short without any option.
static const char scene[] = "step: 0.001\nseconds: 0.05\nballoons: [{model: cube-sphere:2, skin: "
                            "{springs: {structural: 50}}, mass: {per_particle: 0.001}}]\n";

/// The argument of each verb; none if the table says that the verb has no argument.
static const char* target_of(const Verb* verb) {
    static const struct Target {
        const char *verb, *target;
    } other[] = {{"check", "cube"}, {"bench", "contact-hour"}, {"chart", "sphere-gas"}};
    const struct Target* row =
        table_row_of(other, sizeof other / sizeof *other, sizeof *other, verb->name);
    return !verb->target[0] ? NULL : row ? row->target : "scene.yaml";
}

/// A value for each option that takes one.
static const struct Value {
    const char *option, *value;
} value_table[] = {
    {"--seconds", "0.03"},    {"--fps", "30"},        {"--size", "32x18"},
    {"--out", "made"},        {"--mode", "springs"},  {"--input", "log"},
    {"--record", "recorded"}, {"--csv", "-"},         {"--mesh", "end.obj"},
    {"--threads", "2"},       {"--only", "holes"},    {"--fit", "800,1.33"},
    {"--compare", "forward"}, {"--error", "1%"},      {"--budget", "4ms"},
    {"--method", "forward"},  {"--step", "0.002"},    {"--guard", "stop"},
    {"--precision", "any"},   {"--set", "gravity=1"},
};

static void write_text(const char* file, const char* text) {
    FILE* out = fopen(file, "w");
    assert_non_null(out);
    fputs(text, out);
    assert_int_equal(fclose(out), 0);
}

static int open_scratch(void** state) {
    (void)state;
    Fault fault = {0};
    char folder[512];
    // build/PRECISION/tests/test_verbs: the program is two folders up
    if (!paths_sibling("test_verbs", folder, &fault))
        return 1;
    const ssize_t length = readlink("/proc/self/exe", folder, sizeof folder - 1);
    folder[length > 0 ? length : 0] = '\0';
    for (int up = 0; up < 3; up++)
        *strrchr(folder, '/') = '\0';
    snprintf(program, sizeof program, "%s/%s", folder,
             sizeof(real) == sizeof(double) ? "balloon-double" : "balloon");
    if (!mkdtemp(scratch) || chdir(scratch) != 0)
        return 1;
    write_text("scene.yaml", scene);
    write_text("log", "# balloon input 1 scene.yaml\n");
    setenv("XDG_CACHE_HOME", scratch, 1);
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    return 0;
}

static int close_scratch(void** state) {
    (void)state;
    char command[100];
    snprintf(command, sizeof command, "rm -rf %s", scratch);
    return chdir("/") != 0 || system(command) != 0;
}

static pid_t start(char* const* arguments) {
    const pid_t process = fork();
    assert_true(process >= 0);
    if (process > 0)
        return process;
    setpgid(0, 0);
    signal(SIGINT, SIG_DFL); // a shell's background jobs inherit that it is ignored
    if (!freopen("/dev/null", "r", stdin) || !freopen("said", "w", stdout) ||
        !freopen("complained", "w", stderr))
        _exit(127);
    execv(program, arguments);
    _exit(127);
}

/// Whether the process ends within so many hundredths of a second.
static bool ends(pid_t process, int hundredths, int* status) {
    for (int k = 0; k < hundredths; k++) {
        if (waitpid(process, status, WNOHANG) == process)
            return true;
        nanosleep(&(struct timespec){.tv_nsec = 10000000}, NULL);
    }
    return false;
}

/// Run the command and check how it ends.
static int count_bad_end(const char* verb, const char* target, const char* option,
                         const char* value) {
    const char* arguments[6] = {"balloon", verb};
    int count = 2, status = 0;
    for (int k = 0; k < 3; k++)
        if ((const char*[]){target, option, value}[k])
            arguments[count++] = (const char*[]){target, option, value}[k];
    const pid_t process = start((char* const*)arguments);
    bool good = ends(process, PATIENCE, &status);
    if (!good) {
        kill(-process, SIGINT);
        good = ends(process, FORBEARANCE, &status);
        if (!good) {
            kill(-process, SIGKILL);
            waitpid(process, &status, 0);
        } else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) {
            return 0;
        }
    }
    good = good && WIFEXITED(status) &&
           (WEXITSTATUS(status) <= 1 || WEXITSTATUS(status) == 128 + SIGINT);
    if (!good)
        print_message("balloon %s %s %s %s: ends with status %#x\n", verb, target ? target : "",
                      option ? option : "", value ? value : "", (unsigned)status);
    return !good;
}

static const char* value_of(const Option* option) {
    const struct Value* row = table_row_of(value_table, sizeof value_table / sizeof *value_table,
                                           sizeof *value_table, option->name);
    if (option->value && !row)
        fail_msg("%s needs a value in this test's table", option->name);
    return option->value ? row->value : NULL;
}

static void every_verb_ends_with_each_of_its_options_and_with_none(void** state) {
    (void)state;
    int bad = 0;
    for (int v = 0; v < verb_count; v++) {
        const Verb* verb = &verb_table[v];
        bad += count_bad_end(verb->name, NULL, NULL, NULL);
        bad += count_bad_end(verb->name, target_of(verb), NULL, NULL);
        for (int k = 0; k < option_count; k++)
            if (option_table[k].verbs & verb->bit)
                bad += count_bad_end(verb->name, target_of(verb), option_table[k].name,
                                     value_of(&option_table[k]));
    }
    assert_int_equal(bad, 0);
}

static void an_option_of_other_verbs_is_refused(void** state) {
    (void)state;
    for (int v = 0; v < verb_count; v++)
        for (int k = 0; k < option_count; k++) {
            const Option* option = &option_table[k];
            char* words[] = {"balloon", (char*)verb_table[v].name, (char*)option->name,
                             (char*)value_of(option)};
            Options options = {0};
            const Verb* verb;
            Fault fault = {0};
            assert_int_equal(options_read(option->value ? 4 : 3, words, &options, &verb, &fault),
                             (option->verbs & verb_table[v].bit) != 0);
            assert_ptr_equal(verb, &verb_table[v]);
        }
}

static void bits_of_verbs_are_their_own(void** state) {
    (void)state;
    unsigned all = 0;
    for (int v = 0; v < verb_count; v++) {
        assert_int_equal(all & verb_table[v].bit, 0);
        all |= verb_table[v].bit;
    }
    assert_int_equal(all, VERBS_ALL);
}

/// Standard output on a full disk: the results are lost, and the exit status is not 0.
static void results_that_are_lost_are_a_fault(void** state) {
    (void)state;
    static const char* const line_table[] = {
        "--help",
        "--version",
        "list",
        "keys",
        "needs",
        "check cube",
        "run scene.yaml --hash",
        "run scene.yaml --csv -",
        "run scene.yaml --time",
        "run scene.yaml --report",
        "run scene.yaml --csv /dev/full",
        "run scene.yaml --mesh /dev/full",
        "run scene.yaml --record /dev/full",
        "peer scene.yaml --hash --quiet",
        "peer scene.yaml --csv - --quiet",
        "render scene.yaml --size 32x18 --out full",
    };
    for (size_t k = 0; k < sizeof line_table / sizeof *line_table; k++) {
        char command[900];
        snprintf(command, sizeof command,
                 "'%s' %s >/dev/full 2>lost; test $? = 1 && test $(wc -l <lost) = 1 && grep -q 'No "
                 "space left' lost",
                 program, line_table[k]);
        if (system(command) != 0)
            fail_msg("balloon %s >/dev/full: loses its results", line_table[k]);
    }
}

/// Start a run without end, send the signal once it has begun the file, and return its wait status.
static int interrupted(int number, const char* begun, char* const* arguments) {
    int status = 0;
    struct stat about;
    remove(begun);
    const pid_t process = start(arguments);
    while (stat(begun, &about) != 0 && !ends(process, 1, &status))
        ;
    kill(process, number);
    assert_true(ends(process, FORBEARANCE, &status));
    return status;
}

static void a_signal_ends_a_run_with_whole_files(void** state) {
    (void)state;
    static const int signal_table[] = {SIGINT, SIGTERM};
    char* const run[] = {"balloon", "run",  "scene.yaml", "--seconds", "1e6",
                         "--csv",   "rows", "--record",   "events",    NULL};
    char* const film[] = {"balloon", "render", "scene.yaml", "--seconds", "1e6",    "--out",
                          "a.mp4",   "--size", "32x18",      "--record",  "events", NULL};
    for (int k = 0; k < 2; k++) {
        const int expected = 128 + signal_table[k];
        assert_int_equal(WEXITSTATUS(interrupted(signal_table[k], "rows", run)), expected);
        assert_int_equal(system("awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' rows && "
                                "test -z \"$(tail -c 1 rows)\" && tail -n 1 events | grep -q hash"),
                         0);
        assert_int_equal(WEXITSTATUS(interrupted(signal_table[k], "a.mp4.part", film)), expected);
        assert_int_equal(system("! ls a.mp4* 2>/dev/null && tail -n 1 events | grep -q hash"), 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bits_of_verbs_are_their_own),
        cmocka_unit_test(an_option_of_other_verbs_is_refused),
        cmocka_unit_test(every_verb_ends_with_each_of_its_options_and_with_none),
        cmocka_unit_test(a_signal_ends_a_run_with_whole_files),
        cmocka_unit_test(results_that_are_lost_are_a_fault),
    };
    return cmocka_run_group_tests(tests, open_scratch, close_scratch);
}
