#include "lab/bench/machine_limit.h"

#include "base/cpu.h"

const Limits* limits(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return &limits_v3;
#endif
    return &limits_baseline;
}
