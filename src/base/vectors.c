#include "base/vectors.h"

#include "base/cpu.h"

const VectorKernels* vectors(void) {
#ifdef __x86_64__
    if (cpu_is_v3())
        return &vector_kernels_v3;
#endif
    return &vector_kernels_baseline;
}
