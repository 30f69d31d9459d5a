/// Runs of programs: their output, and that none exceeds its limits or outlives its parent.
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "lab/run/bounded_run.h"
#include "law.h"

static Launch shell(const char* script) {
    Launch launch = {.words = 0};
    launch_add(&launch, "/bin/sh");
    launch_add(&launch, "-c");
    launch_add(&launch, "%s", script);
    return launch;
}

static void run(Launch* launch) {
    Fault fault = {0};
    if (!launch_all(launch, 1, 1, NULL, &fault))
        fail_msg("%s: %s", fault.location, fault.text);
}

static void output_and_status_are_those_of_the_program(void** state) {
    (void)state;
    Launch launch = shell("echo out; echo err >&2; exit 3");
    run(&launch);
    assert_string_equal(launch.out, "out\n");
    assert_string_equal(launch.err, "err\n");
    assert_true(WIFEXITED(launch.status) && WEXITSTATUS(launch.status) == 3);
    launch_free(&launch);
}

static void a_word_has_any_length(void** state) {
    (void)state;
    char word[5000];
    memset(word, 'x', sizeof word - 1);
    word[sizeof word - 1] = '\0';
    Launch launch = {.words = 0};
    launch_add(&launch, "/bin/echo");
    launch_add(&launch, "-n");
    launch_add(&launch, "%s", word);
    run(&launch);
    assert_string_equal(launch.out, word);
    launch_free(&launch);
}

static void each_of_several_has_its_own_output(void** state) {
    (void)state;
    Launch launch[5];
    Fault fault = {0};
    for (int k = 0; k < 5; k++) {
        char script[32];
        snprintf(script, sizeof script, "echo %d", k);
        launch[k] = shell(script);
    }
    assert_true(launch_all(launch, 5, 2, NULL, &fault));
    for (int k = 0; k < 5; k++) {
        assert_int_equal(atoi(launch[k].out), k);
        launch_free(&launch[k]);
    }
}

static void what_is_no_program_is_said(void** state) {
    (void)state;
    Launch launch = {.words = 0};
    Fault fault = {0};
    launch_add(&launch, "/nowhere/program");
    assert_false(launch_all(&launch, 1, 1, NULL, &fault));
    assert_string_equal(fault.text, "cannot be started: No such file or directory");
    launch_free(&launch);
}

static void a_limit_of_cpu_time_ends_a_run(void** state) {
    (void)state;
    Launch launch = shell("while :; do :; done");
    launch.cpu_max = 0.2;
    run(&launch);
    assert_true(WIFSIGNALED(launch.status));
    launch_free(&launch);
}

/// A run that responds to SIGTERM ends by itself; another one is killed.
static void a_run_is_asked_to_end_before_it_is_ended(void** state) {
    (void)state;
    Launch launch = shell("trap 'echo so far; exit 5' TERM; while :; do :; done");
    launch.cpu_ask = 0.1;
    launch.cpu_max = 20;
    run(&launch);
    assert_true(WIFEXITED(launch.status) && WEXITSTATUS(launch.status) == 5);
    assert_string_equal(launch.out, "so far\n");
    launch_free(&launch);

    launch = shell("trap '' TERM; while :; do :; done");
    launch.cpu_ask = 0.1;
    launch.cpu_max = 0.2;
    run(&launch);
    assert_true(WIFSIGNALED(launch.status) && WTERMSIG(launch.status) == SIGKILL);
    launch_free(&launch);
}

/// How bounded_run_ending classifies a run of this script.
static Ending ending_of(const char* script, char text[ENDING_TEXT]) {
    Launch launch = shell(script);
    Report report;
    launch.cpu_ask = 0.1;
    launch.cpu_max = 0.2;
    run(&launch);
    report_read(&report, &launch);
    const Ending ending = bounded_run_ending(&launch, &report, text);
    report_free(&report);
    launch_free(&launch);
    return ending;
}

static void a_bounded_run_is_classed_by_its_end(void** state) {
    (void)state;
    static const struct {
        Ending ending;
        const char *text, *script;
    } table[] = {
        {ENDING_GOOD, "", "echo t,x; echo 0,1; echo 1,2"},
        {ENDING_WRONG, "x is not finite", "echo t,x; echo 0,1; echo 1,nan"},
        {ENDING_WRONG, "x is not finite", "echo t,x; echo 0,1; echo 1,-inf"},
        {ENDING_WRONG, "", "echo t,x; echo 0,1"},
        {ENDING_WRONG, "exit status 3 without a sentence", "exit 3"},
        {ENDING_WRONG, "signal 11", "kill -SEGV $$"},
        {ENDING_WRONG, "no answer in 0.2 s of CPU time", "trap '' TERM; while :; do :; done"},
        {ENDING_LONG, "at 3 s",
         "trap 'echo balloon: at 3 s >&2; exit 143' TERM; while :; do :; done"},
        {ENDING_REFUSED, "no such scene", "echo balloon: no such scene >&2; exit 1"},
        {ENDING_STOPPED, "it exploded",
         "echo t,x; echo 0,1; echo balloon: note >&2; echo balloon: it exploded >&2; exit 1"},
    };
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        char text[ENDING_TEXT];
        assert_int_equal(ending_of(table[k].script, text), table[k].ending);
        assert_string_equal(text, table[k].text);
    }
}

static void a_limit_of_time_ends_a_run_that_waits(void** state) {
    (void)state;
    Launch launch = shell("exec sleep 600");
    launch.wall_max = 0.1;
    run(&launch);
    assert_true(WIFSIGNALED(launch.status));
    launch_free(&launch);
}

/// A process that starts a run which never ends, prints its number, and is killed.
static void a_run_ends_with_its_parent(void** state) {
    (void)state;
    int number[2];
    assert_int_equal(pipe(number), 0);
    const pid_t parent = fork();
    if (parent == 0) {
        Launch launch = shell("exec sleep 600");
        Fault fault = {0};
        if (!launch_begin(&launch, &fault) ||
            write(number[1], &launch.process, sizeof launch.process) < 0)
            _exit(1);
        pause();
        _exit(0);
    }
    pid_t child = 0;
    assert_int_equal(read(number[0], &child, sizeof child), sizeof child);
    assert_int_equal(kill(child, 0), 0);
    kill(parent, SIGTERM);
    waitpid(parent, NULL, 0);
    // it has no parent here that waits, so it may remain as a zombie, which sends no output either
    char path[64], line[256] = "", status = 'R';
    snprintf(path, sizeof path, "/proc/%ld/stat", (long)child);
    for (;;) {
        FILE* in = fopen(path, "r");
        if (!in)
            break;
        if (fgets(line, sizeof line, in))
            sscanf(strrchr(line, ')'), ") %c", &status);
        fclose(in);
        if (status == 'Z' || status == 'X')
            break;
        nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
    }
    close(number[0]);
    close(number[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(output_and_status_are_those_of_the_program),
        cmocka_unit_test(a_word_has_any_length),
        cmocka_unit_test(each_of_several_has_its_own_output),
        cmocka_unit_test(what_is_no_program_is_said),
        cmocka_unit_test(a_limit_of_cpu_time_ends_a_run),
        cmocka_unit_test(a_run_is_asked_to_end_before_it_is_ended),
        cmocka_unit_test(a_bounded_run_is_classed_by_its_end),
        cmocka_unit_test(a_limit_of_time_ends_a_run_that_waits),
        cmocka_unit_test(a_run_ends_with_its_parent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
