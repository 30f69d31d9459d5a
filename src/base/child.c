#include "base/child.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

// gcc tells of its sanitizer by a macro, clang by a feature
#ifndef __has_feature
#define __has_feature(name) 0
#endif
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__ || __has_feature(address_sanitizer)
static const int memory_is_limited = 0;
#else
static const int memory_is_limited = 1;
#endif

static void set_limit(int resource, rlim_t soft, rlim_t hard) {
    struct rlimit limit;
    if (getrlimit(resource, &limit) != 0)
        return;
    limit.rlim_max = hard < limit.rlim_max ? hard : limit.rlim_max;
    limit.rlim_cur = soft < limit.rlim_max ? soft : limit.rlim_max;
    setrlimit(resource, &limit);
}

static void limit_child(const ChildLimits* limits, pid_t parent) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent)
        _exit(1); // it has ended already
    const rlim_t seconds = (rlim_t)ceil(limits->cpu_seconds);
    if (seconds > 0)
        set_limit(RLIMIT_CPU, seconds, seconds + 1);
    set_limit(RLIMIT_CORE, 0, 0);
    if (memory_is_limited)
        set_limit(RLIMIT_AS, limits->bytes, limits->bytes);
}

pid_t child_fork(const ChildLimits* limits) {
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0)
        limit_child(limits, parent);
    return child;
}

bool child_send(int pipe_end, const void* bytes, size_t size) {
    for (const char* at = bytes; size > 0;) {
        const ssize_t sent = write(pipe_end, at, size);
        if (sent < 0 && errno != EINTR)
            return false;
        at += sent > 0 ? sent : 0;
        size -= sent > 0 ? (size_t)sent : 0;
    }
    return true;
}

bool child_receive(int pipe_end, void* bytes, size_t size) {
    for (char* at = bytes; size > 0;) {
        const ssize_t received = read(pipe_end, at, size);
        if (received == 0 || (received < 0 && errno != EINTR))
            return false;
        at += received > 0 ? received : 0;
        size -= received > 0 ? (size_t)received : 0;
    }
    return true;
}
