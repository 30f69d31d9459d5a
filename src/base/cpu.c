#include "base/cpu.h"

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
    static int known = -1;
    if (known < 0)
        known = look();
    return known;
}
