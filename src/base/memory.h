/// Arrays for the whole life of a scene: zeroed, aligned to a cache line, freed with free().
///
/// Their length is rounded up to whole cache lines, so that kernels may read up to the next
/// multiple of eight elements. A step allocates nothing; what runs out of memory stops at once.
#ifndef BALLOON_BASE_MEMORY_H
#define BALLOON_BASE_MEMORY_H

#include <stddef.h>

enum { CACHE_LINE = 64 }; ///< [bytes]

void* memory_array(size_t count, size_t size);

/// new_array(real4, n): a zeroed real4[n], with room up to the next multiple of eight.
#define new_array(Type, count) memory_array((size_t)(count), sizeof(Type))

#endif
