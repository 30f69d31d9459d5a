#include "lab/run/launch.h"

#include <errno.h>
#include <spawn.h>
#include <stdarg.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/memory.h"

extern char** environ;

enum { MAX_PARALLEL = 16 };

/// A running program and the files of its output.
typedef struct Running {
    Launch* launch; ///< NULL: this slot is free
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

/// Wait for the program that ends next, and read its output.
static void end_one(Running* running) {
    int status;
    const pid_t process = wait(&status);
    for (int k = 0; k < MAX_PARALLEL; k++)
        if (running[k].launch && running[k].process == process) {
            running[k].launch->status = status;
            running[k].launch->out = read_all(running[k].out);
            running[k].launch->err = read_all(running[k].err);
            running[k].launch = NULL;
        }
}

static int free_slot(const Running* running, int parallel) {
    for (int k = 0; k < parallel; k++)
        if (!running[k].launch)
            return k;
    return -1;
}

bool launch_all(Launch* launch, int count, int parallel, const char* title, Fault* fault) {
    ASSERT(parallel <= MAX_PARALLEL, "there is a slot for each running program");
    const bool progress = isatty(STDERR_FILENO);
    Running running[MAX_PARALLEL] = {{0}};
    int running_count = 0, next = 0;
    bool good = true;
    while (running_count > 0 || (good && next < count)) {
        const int slot = free_slot(running, parallel);
        if (good && next < count && slot >= 0) {
            good = begin(&running[slot], &launch[next++], fault);
            running_count += good;
            continue;
        }
        end_one(running);
        running_count--;
        if (progress)
            fprintf(stderr, "\r%s: %d of %d ", title, next - running_count, count);
    }
    if (progress)
        fprintf(stderr, "\r%*s\r", (int)strlen(title) + 24, "");
    return good;
}

void launch_free(Launch* launch) {
    for (int k = 0; k < launch->words; k++)
        free(launch->word[k]);
    forget_output(launch);
    *launch = (Launch){.words = 0};
}
