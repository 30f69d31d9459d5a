#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory_missing.h"

void memory_missing(const char* what) {
    fprintf(stderr, "balloon: no memory for %s\n", what);
    exit(EXIT_FAILURE);
}

void* memory_array(size_t count, size_t size) {
    const size_t eights = (count + 7) / 8 * 8;
    const size_t bytes = (eights * size + CACHE_LINE) / CACHE_LINE * CACHE_LINE;
    void* array = aligned_alloc(CACHE_LINE, bytes);
    if (!array) {
        char what[64];
        snprintf(what, sizeof what, "an array of %zu bytes", bytes);
        memory_missing(what);
    }
    return memset(array, 0, bytes);
}
