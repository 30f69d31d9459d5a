#include "base/cpu.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

static bool look(void) {
#ifdef __x86_64__
    const char* said = getenv("BALLOON_CPU");
    __builtin_cpu_init();
    return !(said && strcmp(said, "baseline") == 0) && __builtin_cpu_supports("avx2") &&
           __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
           __builtin_cpu_supports("bmi2");
#else
    return false;
#endif
}

bool cpu_is_v3(void) {
    static atomic_int known = -1; // whichever thread asks first
    int now = atomic_load_explicit(&known, memory_order_relaxed);
    if (now < 0)
        atomic_store_explicit(&known, now = look(), memory_order_relaxed);
    return now;
}
