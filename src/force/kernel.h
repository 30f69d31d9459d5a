/// The loops over particles in which a step spends its time, compiled once for each kind of
/// machine (base/cpu.h).
#ifndef BALLOON_FORCE_KERNEL_H
#define BALLOON_FORCE_KERNEL_H

#include "force/sweep.h"
#include "force/uniform.h"

typedef struct Kernels {
    /// coordinate[k][i] = x[i][k], particles from … to - 1, whole slices.
    void (*split)(const real4* x, int from, int to, real* const coordinate[3]);

    /// sweep.h, over slices from … to - 1. gradient: NULL without SWEEP_GRADIENT.
    SweepSums (*sweep)(const Slices* slices, int from, int to, const real4* x, unsigned flags,
                       SpringLaw law, real4* f, real4* gradient);

    SweepBounds (*bounds)(const Slices* slices, int from, int to, const real4* x,
                          const real* inverse_mass);

    /// uniform.h, over particles from … to - 1: f += the uniform forces; v += h f / m if h > 0.
    void (*uniform)(const Uniform* uniform, int from, int to, const real4* gradient,
                    const real* mass, const real* inverse_mass, real h, real4* v, real4* f);
} Kernels;

extern const Kernels kernels_baseline;
#ifdef __x86_64__
extern const Kernels kernels_v3;
#endif

/// The kernels for this machine.
const Kernels* kernels(void);

#endif
