#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void* memory_array(size_t count, size_t size) {
    const size_t eights = (count + 7) / 8 * 8;
    const size_t bytes = (eights * size + CACHE_LINE) / CACHE_LINE * CACHE_LINE;
    void* array = aligned_alloc(CACHE_LINE, bytes);
    if (!array) {
        fprintf(stderr, "balloon: no memory for an array of %zu bytes\n", bytes);
        exit(1);
    }
    return memset(array, 0, bytes);
}
