/// Time, and CPU time, for what is measured; nothing that is simulated may depend on it.
#ifndef BALLOON_BASE_CLOCK_H
#define BALLOON_BASE_CLOCK_H

#include <time.h>

/// What a clock of the system reads: CLOCK_MONOTONIC, CLOCK_THREAD_CPUTIME_ID, … [s]
static inline double clock_seconds(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
