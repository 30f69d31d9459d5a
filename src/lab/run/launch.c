#include "lab/run/launch.h"

#include <errno.h>
#include <spawn.h>
#include <stdarg.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/memory.h"

extern char** environ;

enum { SIDE_BY_SIDE_MOST = 16 };

/// A program that runs: where its output goes, until it is read.
typedef struct Running {
    Launch* launch; ///< NULL: this place is free
    pid_t process;
    FILE* out;
    FILE* err;
} Running;

void launch_add(Launch* launch, const char* format, ...) {
    ASSERT(launch->words < LAUNCH_WORDS, "a command line has room for its words");
    char word[512];
    va_list list;
    va_start(list, format);
    vsnprintf(word, sizeof word, format, list);
    va_end(list);
    launch->word[launch->words] = new_array(char, strlen(word) + 1);
    strcpy(launch->word[launch->words++], word);
}

bool launch_same(const Launch* a, const Launch* b) {
    if (a->words != b->words)
        return false;
    for (int k = 0; k < a->words; k++)
        if (strcmp(a->word[k], b->word[k]) != 0)
            return false;
    return true;
}

static char* read_all(FILE* file) {
    fseek(file, 0, SEEK_END);
    const long size = ftell(file);
    rewind(file);
    char* text = new_array(char, size + 1);
    text[fread(text, 1, (size_t)size, file)] = '\0';
    fclose(file);
    return text;
}

static void forget_output(Launch* launch) {
    free(launch->out);
    free(launch->err);
    launch->out = launch->err = NULL;
}

static bool begin(Running* running, Launch* launch, Fault* fault) {
    forget_output(launch);
    *running = (Running){.launch = launch, .out = tmpfile(), .err = tmpfile()};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    int bad = !running->out || !running->err ? errno : 0;
    if (!bad) {
        posix_spawn_file_actions_adddup2(&actions, fileno(running->out), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, fileno(running->err), STDERR_FILENO);
        bad =
            posix_spawn(&running->process, launch->word[0], &actions, NULL, launch->word, environ);
    }
    posix_spawn_file_actions_destroy(&actions);
    if (!bad)
        return true;
    if (running->out)
        fclose(running->out);
    if (running->err)
        fclose(running->err);
    running->launch = NULL;
    return fault_set(fault, launch->word[0], "cannot be started: %s", strerror(bad));
}

/// Wait for the one that ends next.
static void end_one(Running* running) {
    int status;
    const pid_t process = wait(&status);
    for (int k = 0; k < SIDE_BY_SIDE_MOST; k++)
        if (running[k].launch && running[k].process == process) {
            running[k].launch->status = status;
            running[k].launch->out = read_all(running[k].out);
            running[k].launch->err = read_all(running[k].err);
            running[k].launch = NULL;
        }
}

static int free_place(const Running* running, int side_by_side) {
    for (int k = 0; k < side_by_side; k++)
        if (!running[k].launch)
            return k;
    return -1;
}

bool launch_all(Launch* launch, int count, int side_by_side, const char* what, Fault* fault) {
    ASSERT(side_by_side <= SIDE_BY_SIDE_MOST, "there is a place for each that runs");
    const bool say = isatty(STDERR_FILENO);
    Running running[SIDE_BY_SIDE_MOST] = {{0}};
    int going = 0, next = 0;
    bool good = true;
    while (going > 0 || (good && next < count)) {
        const int place = free_place(running, side_by_side);
        if (good && next < count && place >= 0) {
            good = begin(&running[place], &launch[next++], fault);
            going += good;
            continue;
        }
        end_one(running);
        going--;
        if (say)
            fprintf(stderr, "\r%s: %d of %d ", what, next - going, count);
    }
    if (say)
        fprintf(stderr, "\r%*s\r", (int)strlen(what) + 24, "");
    return good;
}

void launch_free(Launch* launch) {
    for (int k = 0; k < launch->words; k++)
        free(launch->word[k]);
    forget_output(launch);
    *launch = (Launch){.words = 0};
}
