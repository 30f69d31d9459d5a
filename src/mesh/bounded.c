#include "mesh/bounded.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/child.h"

/// Sent by the child before the arrays.
typedef struct Message {
    bool good;
    int point_count, face_count;
    Fault fault;
} Message;

/// In the child. Its output is discarded: the parent reports faults.
static void read_and_send(MeshReader reader, const char* path, int pipe_end) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    signal(SIGALRM, SIG_DFL);
    alarm(2 * BOUNDED_SECONDS);
    MeshSource source;
    Message message = {.good = false};
    message.good = reader(&source, path, &message.fault);
    if (message.good) {
        message.point_count = source.point_count;
        message.face_count = source.face_count;
    }
    bool sent = child_send(pipe_end, &message, sizeof message);
    if (message.good)
        sent =
            sent &&
            child_send(pipe_end, source.point, (size_t)source.point_count * sizeof *source.point) &&
            child_send(pipe_end, source.face, (size_t)source.face_count * sizeof *source.face);
    _exit(sent ? 0 : 1);
}

static bool receive(MeshSource* source, const char* path, int pipe_end, Fault* fault,
                    bool* complete) {
    Message message;
    *complete = child_receive(pipe_end, &message, sizeof message);
    if (!*complete)
        return false;
    if (!message.good)
        return fault_set(fault, message.fault.location, "%s", message.fault.text);
    source_make(source, path, message.point_count, message.face_count);
    *complete =
        child_receive(pipe_end, source->point,
                      (size_t)source->point_count * sizeof *source->point) &&
        child_receive(pipe_end, source->face, (size_t)source->face_count * sizeof *source->face);
    if (!*complete)
        source_free(source);
    return *complete;
}

/// Size of this process's address space [bytes]; 0 if the system does not report it.
static unsigned long own_bytes(void) {
    unsigned long pages = 0;
    FILE* in = fopen("/proc/self/statm", "r");
    if (in && fscanf(in, "%lu", &pages) != 1)
        pages = 0;
    if (in)
        fclose(in);
    return pages * (unsigned long)sysconf(_SC_PAGESIZE);
}

bool bounded_read(MeshReader reader, MeshSource* source, const char* path, Fault* fault) {
    *source = (MeshSource){0};
    int end[2], status = 0;
    if (pipe(end) != 0)
        return fault_set(fault, path, "it cannot be read: %s", strerror(errno));
    const pid_t child = child_fork(
        &(ChildLimits){.cpu_seconds = BOUNDED_SECONDS, .bytes = own_bytes() + BOUNDED_BYTES});
    if (child == 0) {
        close(end[0]);
        read_and_send(reader, path, end[1]);
    }
    close(end[1]);
    bool complete = false;
    const bool good = child > 0 && receive(source, path, end[0], fault, &complete);
    close(end[0]);
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (complete)
        return good;
    const int by = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (by == SIGXCPU || by == SIGALRM || by == SIGKILL)
        return fault_set(fault, path, "it cannot be read within %d s; it is damaged",
                         BOUNDED_SECONDS);
    return fault_set(fault, path,
                     "reading it takes too much memory or depth, or crashes; it is damaged");
}
