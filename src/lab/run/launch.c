#include "lab/run/launch.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/child.h"
#include "base/clock.h"
#include "base/memory.h"

const double LAUNCH_CPU_MAX = 3600;
const unsigned long LAUNCH_BYTES_MAX = 8ul << 30;

void launch_add(Launch* launch, const char* format, ...) {
    ASSERT(launch->words < LAUNCH_WORDS, "a command line has room for its words");
    va_list list, again;
    va_start(list, format);
    va_copy(again, list);
    const int length = vsnprintf(NULL, 0, format, list);
    char* word = new_array(char, length + 1);
    vsnprintf(word, (size_t)length + 1, format, again);
    va_end(again);
    va_end(list);
    launch->word[launch->words++] = word;
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

/// In the child: execute the program, or send the error number to the parent.
static void execute(const Launch* launch, int failed) {
    dup2(fileno(launch->out_file), STDOUT_FILENO);
    dup2(fileno(launch->err_file), STDERR_FILENO);
    execv(launch->word[0], launch->word);
    const int reason = errno;
    _exit(write(failed, &reason, sizeof reason) < 0 ? 2 : 1);
}

/// Start the process; returns 0, or an error number.
static int start_process(Launch* launch) {
    int failed[2], reason = 0;
    if (!launch->out_file || !launch->err_file || pipe(failed) != 0)
        return errno;
    fcntl(failed[1], F_SETFD, FD_CLOEXEC);
    fcntl(failed[0], F_SETFD, FD_CLOEXEC);
    // the parent watches the CPU time: RLIMIT_CPU would make the CPU clock coarse, by which the run
    // measures itself
    launch->process =
        child_fork(&(ChildLimits){.bytes = launch->bytes > 0 ? launch->bytes : LAUNCH_BYTES_MAX});
    if (launch->process == 0)
        execute(launch, failed[1]);
    if (launch->process < 0)
        reason = errno;
    close(failed[1]);
    // exec closes the pipe, so nothing is read if the program has started
    if (read(failed[0], &reason, sizeof reason) > 0)
        waitpid(launch->process, &launch->status, 0);
    close(failed[0]);
    return reason;
}

bool launch_begin(Launch* launch, Fault* fault) {
    forget_output(launch);
    launch->out_file = tmpfile();
    launch->err_file = tmpfile();
    launch->start = clock_seconds(CLOCK_MONOTONIC);
    launch->end_requested = false;
    const int reason = start_process(launch);
    if (!reason)
        return true;
    launch->process = 0;
    if (launch->out_file)
        fclose(launch->out_file);
    if (launch->err_file)
        fclose(launch->err_file);
    return fault_set(fault, launch->word[0], "cannot be started: %s", strerror(reason));
}

/// Ask a run that exceeds its limits to end, or kill it.
static void enforce_limits(Launch* launch) {
    const double wall = clock_seconds(CLOCK_MONOTONIC) - launch->start;
    const double cpu_max = launch->cpu_max > 0 ? launch->cpu_max : LAUNCH_CPU_MAX;
    clockid_t clock;
    const double cpu = clock_getcpuclockid(launch->process, &clock) == 0 ? clock_seconds(clock) : 0;
    if ((launch->wall_max > 0 && wall > launch->wall_max) || cpu > cpu_max)
        kill(launch->process, SIGKILL);
    else if (launch->cpu_ask > 0 && cpu > launch->cpu_ask && !launch->end_requested) {
        launch->end_requested = true; // a second signal would end the program without a report
        kill(launch->process, SIGTERM);
    }
}

bool launch_has_ended(Launch* launch) {
    enforce_limits(launch);
    const pid_t ended = waitpid(launch->process, &launch->status, WNOHANG);
    if (ended != launch->process)
        return false;
    launch->process = 0;
    launch->out = read_all(launch->out_file);
    launch->err = read_all(launch->err_file);
    return true;
}

/// Wait until one of the runs has ended.
static void wait_for_one(Launch** running, int* count) {
    const struct timespec moment = {.tv_nsec = 1000000};
    for (;;) {
        for (int k = 0; k < *count; k++)
            if (launch_has_ended(running[k])) {
                running[k] = running[--*count];
                return;
            }
        nanosleep(&moment, NULL);
    }
}

bool launch_all(Launch* launch, int count, int parallel, const char* title, Fault* fault) {
    const bool say = title && isatty(STDERR_FILENO);
    Launch** running = new_array(Launch*, parallel);
    int running_count = 0, next = 0;
    bool good = true;
    while (running_count > 0 || (good && next < count)) {
        if (good && next < count && running_count < parallel) {
            running[running_count] = &launch[next++];
            good = launch_begin(running[running_count], fault);
            running_count += good;
            continue;
        }
        wait_for_one(running, &running_count);
        if (say)
            fprintf(stderr, "\r%s: %d of %d ", title, next - running_count, count);
    }
    if (say)
        fprintf(stderr, "\r%*s\r", (int)strlen(title) + 24, "");
    free(running);
    return good;
}

void launch_free(Launch* launch) {
    if (launch->process > 0) {
        kill(launch->process, SIGKILL);
        waitpid(launch->process, &launch->status, 0);
        fclose(launch->out_file);
        fclose(launch->err_file);
    }
    for (int k = 0; k < launch->words; k++)
        free(launch->word[k]);
    forget_output(launch);
    *launch = (Launch){.words = 0};
}
