#include "force/kernel.h"

#include "base/cpu.h"

const Kernels* kernels(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return &kernels_v3;
#endif
    return &kernels_baseline;
}
