/// The program's own random numbers, so that a seed gives the same sequence everywhere.
/// SplitMix64. Source: G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom number generators,
/// OOPSLA 2014.
#ifndef BALLOON_BASE_RANDOM_H
#define BALLOON_BASE_RANDOM_H

#include <stdint.h>

typedef struct Random {
    uint64_t state; ///< the seed at first
} Random;

/// Uniform in [0, 1).
static inline double random_next(Random* random) {
    uint64_t z = (random->state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

#endif
