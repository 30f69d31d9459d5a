/// Which compilation of a kernel this machine runs (Makefile: sources that end in _kernel.c).
///
/// All give the same bits. BALLOON_CPU=baseline in the environment selects the baseline, to compare.
#ifndef BALLOON_BASE_CPU_H
#define BALLOON_BASE_CPU_H

#include <stdbool.h>

/// An x86-64-v3 with eight floats in a register; the same answer for as long as the program runs.
bool cpu_is_v3(void);

#endif
