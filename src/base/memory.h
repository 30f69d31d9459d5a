/// Arrays that live as long as a scene: zeroed, aligned to a cache line, freed with free().
///
/// Their length is rounded up to whole cache lines and to a multiple of eight elements, so that
/// kernels may read whole groups of eight. A step allocates nothing. The program ends with a sentence
/// if memory runs out.
#ifndef BALLOON_BASE_MEMORY_H
#define BALLOON_BASE_MEMORY_H

#include <stddef.h>

enum { CACHE_LINE = 64 }; ///< [bytes]

void* memory_array(size_t count, size_t size);

/// new_array(real4, n): a zeroed real4[n], its capacity rounded up to a multiple of eight.
#define new_array(Type, count) memory_array((size_t)(count), sizeof(Type))

#endif
