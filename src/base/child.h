/// Child processes that cannot outlive their parent, nor use more than they are allowed.
#ifndef BALLOON_BASE_CHILD_H
#define BALLOON_BASE_CHILD_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

typedef struct ChildLimits {
    double cpu_seconds;  ///< CPU time, rounded up to whole seconds; SIGXCPU ends the child [s]. 0:
                         ///< none; a limit makes the child's own CPU clock as coarse as a tick
    unsigned long bytes; ///< address space [bytes]; not held under the address sanitizer, which
                         ///< reserves terabytes
} ChildLimits;

/// fork(), with these limits in the child, no core dump, and, on Linux, SIGKILL when the parent's
/// thread ends. Returns as fork() does.
pid_t child_fork(const ChildLimits* limits);

/// Write, and read, all of the bytes through a pipe; false where its other end is closed before.
bool child_send(int pipe_end, const void* bytes, size_t size);
bool child_receive(int pipe_end, void* bytes, size_t size);

#endif
