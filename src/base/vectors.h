/// Vector operations of conjugate gradients, over whole arrays. Spare lanes are zero and stay zero.
#ifndef BALLOON_BASE_VECTORS_H
#define BALLOON_BASE_VECTORS_H

#include "base/vec.h"

typedef struct VectorKernels {
    /// sum of a . b, products in real, their sum in double
    double (*dot)(const real4* a, const real4* b, int count);

    /// sum of w a . a, products in real, their sum in double
    double (*weighted_squares)(const real* w, const real4* a, int count);

    /// the largest a . a
    real (*max_squared)(const real4* a, int count);

    /// a += s b
    void (*add)(real4* a, real s, const real4* b, int count);

    /// a = b + s a
    void (*scale_add)(real4* a, real s, const real4* b, int count);
} VectorKernels;

extern const VectorKernels vector_kernels_baseline;
#ifdef __x86_64__
extern const VectorKernels vector_kernels_v3;
#endif

/// The kernels for this machine (base/cpu.h).
const VectorKernels* vectors(void);

#endif
