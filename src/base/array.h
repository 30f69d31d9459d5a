/// Growable arrays: a pointer, a count and a capacity, which the owner keeps side by side.
///
///     array_reserve(list->item, list->count, list->capacity);
///     list->item[list->count++] = item;
///
/// Capacity doubles, so n appended elements cost time linear in n. Begin with NULL, 0, 0; free with
/// free(). Elements move when the array grows: keep indices, not pointers.
#ifndef BALLOON_BASE_ARRAY_H
#define BALLOON_BASE_ARRAY_H

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

enum { ARRAY_CAPACITY_MIN = 16 };

/// Make sure that element [count] exists: `array` is replaced when it is full.
#define array_reserve(array, count, capacity)                                                      \
    ((array) = array_grown((array), (count), &(capacity), sizeof *(array)))

static inline void* array_grown(void* array, int count, int* capacity, size_t size) {
    if (count < *capacity)
        return array;
    *capacity = *capacity ? 2 * *capacity : ARRAY_CAPACITY_MIN;
    void* larger = memory_array((size_t)*capacity, size);
    if (count > 0)
        memcpy(larger, array, (size_t)count * size);
    free(array);
    return larger;
}

#endif
